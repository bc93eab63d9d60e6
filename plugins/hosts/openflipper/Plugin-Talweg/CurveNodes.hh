// Nodes of the scene for a drawing besides the host's own lines: drawn lines and points, the leg to
// the mouse, combs, and a mark. They get places and colours, and know no drawing.
#pragma once

#include <optional>
#include <vector>

#include <ACG/Scenegraph/LineNode.hh>
#include <ACG/Scenegraph/MaterialNode.hh>
#include <ACG/Scenegraph/PointNode.hh>

namespace talweg::openflipper {

struct PointLook {
  ACG::Vec3d at;
  ACG::Vec4f colour;
};

struct LineLook {
  std::vector<ACG::Vec3d> points;
  bool closed = false;
  ACG::Vec4f colour;
};

/// Exists only with a window. The nodes cannot be picked, except the parts that the mouse can grab.
class CurveNodes {
 public:
  CurveNodes();
  ~CurveNodes();
  CurveNodes(const CurveNodes&) = delete;
  CurveNodes& operator=(const CurveNodes&) = delete;

  void set_visible(bool visible);
  /// Points behind the mesh are faint.
  void show_points(const std::vector<PointLook>& points);
  void show_lines(const std::vector<LineLook>& lines);
  void show_leg(const LineLook& leg);  ///< an empty line removes the leg
  void show_comb(const std::vector<LineLook>& lines);
  void show_mark(const std::optional<ACG::Vec3d>& at);  ///< drawn in front of everything else

 private:
  ACG::SceneGraph::MaterialNode* root_;  // owned by the scene, with all nodes below
  ACG::SceneGraph::PointNode *points_, *faint_points_, *mark_rim_, *mark_;
  ACG::SceneGraph::LineNode *lines_, *leg_, *comb_, *faint_comb_;
};

}  // namespace talweg::openflipper

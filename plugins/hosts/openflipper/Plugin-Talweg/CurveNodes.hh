// Curve nodes are what the scene shows of a drawing besides the host's own lines: the drawn lines
// and points, the leg to the mouse, combs, a mark. They know no drawing, only places and colours.
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

/// Only with a window. What a person cannot grab cannot be picked either.
class CurveNodes {
 public:
  CurveNodes();
  ~CurveNodes();
  CurveNodes(const CurveNodes&) = delete;
  CurveNodes& operator=(const CurveNodes&) = delete;

  void set_visible(bool visible);
  /// Points behind the body are faint.
  void show_points(const std::vector<PointLook>& points);
  void show_lines(const std::vector<LineLook>& lines);
  void show_leg(const LineLook& leg);  ///< without points: none
  void show_comb(const std::vector<LineLook>& lines);
  void show_mark(const std::optional<ACG::Vec3d>& at);  ///< before everything else

 private:
  ACG::SceneGraph::MaterialNode* root_;  // the scene's, with all below
  ACG::SceneGraph::PointNode *points_, *faint_points_, *mark_rim_, *mark_;
  ACG::SceneGraph::LineNode *lines_, *leg_, *comb_, *faint_comb_;
};

}  // namespace talweg::openflipper

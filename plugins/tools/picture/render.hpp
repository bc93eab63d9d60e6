// Renders pictures of curves on a shaded mesh, without a display.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "tools/picture/image.hpp"

namespace talweg::picture {

/// sRGB components in [0, 1].
using Color = std::array<double, 3>;

/// A polyline on or near the mesh, drawn as a round tube.
struct PictureCurve {
  std::vector<Point> points;
  bool closed = false;
  Color color{0.1, 0.1, 0.1};
  double width = 5;  ///< pixels, > 0
};

/// The part of the mesh that a panel shows.
enum class Fit {
  kAuto,    ///< the curve with its surroundings
  kCurve,   ///< the curve, tightly
  kMesh,    ///< the whole mesh
  kDetail,  ///< the place of largest turning of the first curve, seen from straight above
};

/// An enlarged place: everything within `radius` of its centre.
struct Detail {
  Point center = Point::Zero();
  Point normal = Point::UnitZ();  ///< direction from the place to the viewer
  double radius = 0;              ///< mesh units; 0: five edges
};

/// One view. Panels stand side by side in the picture.
struct Panel {
  std::string caption;
  std::vector<std::size_t> curves;  ///< which of the scene's curves are drawn; empty: all
  Fit fit = Fit::kAuto;
  double zoom = 1;  ///< > 0; enlarges the choice of `fit`
  /// From the mesh towards the viewer; empty: the direction that sees most of the curves.
  std::optional<Point> view;
  std::optional<Detail> detail = std::nullopt;  ///< shown instead of the choice of `fit`
};

struct Scene {
  MeshLists mesh;
  std::vector<Color> face_colors;  ///< a colour for each face; empty: the material's colour
  std::vector<PictureCurve> curves;
  std::vector<Panel> panels;  ///< empty: one panel with everything
  std::optional<Point> up;    ///< empty: y; for open sheets, the side that the sheet faces
};

struct RenderOptions {
  std::size_t panel_width = 640;   ///< pixels, in [16, 8192]
  std::size_t panel_height = 640;  ///< pixels, in [16, 8192]
  std::size_t supersampling = 3;   ///< samples per pixel in x and in y, in [1, 8]
  bool captions = true;
  bool mesh_edges = true;  ///< thin lines along the mesh's edges, if edges are long enough
  Color background{0.965, 0.965, 0.96};
  Color material{0.91, 0.85, 0.775};

  /// Throws Error(kBadUsage), which names the field and its bound.
  void validate() const;
};

/// Draws the scene by orthographic projection with a z-buffer. All panels that neither choose their
/// own direction nor show a detail share one direction, so that they can be compared.
/// O(faces · panels + samples). Deterministic.
/// Throws Error(kBadMesh) for a mesh without faces, a vertex id out of range, a vertex of a face
/// that is not finite, or a mesh without extent; Error(kBadCurve) for a point that is not finite;
/// Error(kBadUsage) for a curve number out of range, an option out of its bounds, or more or fewer
/// colours than faces.
Image render(const Scene& scene, const RenderOptions& options = {});

/// The place that panels with this view show for Fit::kDetail. The first curve must have points.
/// Throws as render() does.
Detail turning_detail(const Scene& scene, const std::optional<Point>& view = {});

/// The surroundings of a point within `radius` (mesh units; 0: five edges), from the direction that
/// shows its curves best: straight from above, or obliquely if another part of the mesh hides them.
/// O(faces). Throws as render() does.
Detail detail_at(const Scene& scene, const Point& center, double radius = 0);

}  // namespace talweg::picture

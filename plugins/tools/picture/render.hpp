// The renderer makes pictures of curves on a shaded mesh, without a display.
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

/// What a panel shows of the mesh.
enum class Fit {
  kAuto,    ///< the curve with its surroundings
  kCurve,   ///< the curve, tightly
  kMesh,    ///< the whole mesh
  kDetail,  ///< the place where the first curve turns most, seen from straight above it
};

/// A place to show enlarged: what lies within `radius` of its centre.
struct Detail {
  Point center = Point::Zero();
  Point normal = Point::UnitZ();  ///< the direction to look from
  double radius = 0;              ///< mesh units; 0: five edges
};

/// One view. Panels stand side by side in the picture.
struct Panel {
  std::string caption;
  std::vector<std::size_t> curves;  ///< which of the scene's curves are drawn; empty: all
  Fit fit = Fit::kAuto;
  double zoom = 1;  ///< > 0; enlarges what `fit` chose
  /// From the mesh towards the viewer; empty: the direction that sees most of the curves.
  std::optional<Point> view;
  std::optional<Detail> detail = std::nullopt;  ///< shown instead of what `fit` chooses
};

struct Scene {
  MeshLists mesh;
  std::vector<Color> face_colors;  ///< one per face; empty: all of the material's
  std::vector<PictureCurve> curves;
  std::vector<Panel> panels;  ///< empty: one panel with everything
  std::optional<Point> up;    ///< empty: y, and for open sheets the side that they face
};

struct RenderOptions {
  std::size_t panel_width = 640;   ///< pixels, in [16, 8192]
  std::size_t panel_height = 640;  ///< pixels, in [16, 8192]
  std::size_t supersampling = 3;   ///< samples per pixel in x and in y, in [1, 8]
  bool captions = true;
  bool mesh_edges = true;  ///< thin lines along the mesh's edges where these are long enough
  Color background{0.965, 0.965, 0.96};
  Color material{0.91, 0.85, 0.775};

  /// Throws Error(kBadUsage) naming the field and its bound.
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

/// What panels with this view show by Fit::kDetail. Needs a first curve with points. Throws as
/// render() does.
Detail turning_detail(const Scene& scene, const std::optional<Point>& view = {});

/// What lies within `radius` (mesh units; 0: five edges) of a point, from where the curves near it
/// are seen best: straight from above, or from aside where something is in the way. O(faces).
/// Throws as render() does.
Detail detail_at(const Scene& scene, const Point& center, double radius = 0);

}  // namespace talweg::picture

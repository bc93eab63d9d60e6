// The surface deviation tells how far apart curves lie, measured along the surface.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

class PolylineDistance;

/// Distance of all points of some curves to others.
struct OneSidedSurfaceDeviation {
  double max = 0;   ///< mesh units; infinite where none of the others can be reached
  double mean = 0;  ///< mesh units: over the length of the curves
  SurfacePoint at;  ///< the point of the curves where the distance is largest
};

/// Both directions: a result that cuts a corner stays near the drawing, but the drawing's corner
/// lies far from the result.
struct SurfaceDeviation {
  OneSidedSurfaceDeviation to_drawn;    ///< of the result's points to the drawing
  OneSidedSurfaceDeviation from_drawn;  ///< of the drawing's points to the result

  /// The one whose maximum is larger.
  [[nodiscard]] const OneSidedSurfaceDeviation& larger() const {
    return to_drawn.max >= from_drawn.max ? to_drawn : from_drawn;
  }
};

/// Exact distances along the surface of every point of the segments of `from`, not only of their
/// ends, to the curves that `to` is set to; the same as `to_curves`.
///
/// `max` is the distance at a point of the curve, and the true maximum is larger by at most 1e-3
/// of it or of the curves' mean segment, whichever is more: distances change no faster than the
/// point moves, and within a face are at most those by way of any point or segment in it;
/// intervals are halved until these bounds rule them out. `mean` is integrated by adaptive
/// Simpson's rule to about that accuracy.
/// Throws Error(kBadCurve) when there is no curve, one has no points, or two neighbours share no
/// face; Cancelled when `progress` (stage "measure") says so.
OneSidedSurfaceDeviation one_sided_deviation(const Surface& surface,
                                             std::span<const SurfaceCurve> from,
                                             PolylineDistance& to,
                                             std::span<const SurfaceCurve> to_curves,
                                             const Progress& progress = {});

/// Measures both directions again and again on one mesh. Holds the working memory, O(mesh), which
/// is made when first needed. One thread at a time; the mesh must outlive the object.
class DeviationMeter {
 public:
  explicit DeviationMeter(const SurfaceMesh& mesh);
  ~DeviationMeter();

  /// All of `result` against all of `drawn`. Goes along the curves part by part, so each part costs
  /// what lies within its own distance. Throws as one_sided_deviation() does.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, const Progress& progress = {});
  /// The same with a distance of the caller's that is set to `drawn` already, and used as a whole:
  /// cheaper where its band is there.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, PolylineDistance& to_drawn,
                           const Progress& progress = {});
  /// The same as the first, or nothing where it is `limit` (mesh units) or more, either way: costs
  /// what lies nearer than that.
  std::optional<SurfaceDeviation> measure_below(double limit, std::span<const SurfaceCurve> result,
                                                std::span<const SurfaceCurve> drawn,
                                                const Progress& progress = {});

 private:
  const SurfaceMesh* mesh_;
  std::unique_ptr<PolylineDistance> distance_;
};

}  // namespace talweg

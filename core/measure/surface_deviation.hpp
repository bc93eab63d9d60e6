// The surface deviation of curves is their largest and mean distance along the surface.
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

/// Distances of all points of some curves to others. If the budget ended the measurement, `max` and
/// `mean` are upper bounds.
struct OneSidedSurfaceDeviation {
  double max = 0;       ///< mesh units; infinite if no other curve can be reached
  double mean = 0;      ///< mesh units: averaged over the length of the curves
  SurfacePoint at;      ///< the point with the largest distance or bound
  bool exact = true;    ///< whether `max` is a distance, not a bound
  double at_least = 0;  ///< mesh units: lower bound of the maximum; `max` if exact
};

/// Distances in both directions. Both are needed: a result that cuts a corner stays near the
/// drawing, but the drawing's corner lies far from the result.
struct SurfaceDeviation {
  OneSidedSurfaceDeviation to_drawn;    ///< of the result's points to the drawing
  OneSidedSurfaceDeviation from_drawn;  ///< of the drawing's points to the result

  /// The direction with the larger maximum.
  [[nodiscard]] const OneSidedSurfaceDeviation& larger() const {
    return to_drawn.max >= from_drawn.max ? to_drawn : from_drawn;
  }
  [[nodiscard]] bool is_exact() const { return to_drawn.exact && from_drawn.exact; }
};

/// Exact distances along the surface from all points of the segments of `from`, not only their
/// ends, to `to_curves`. The caller must have set `to` to these curves.
///
/// `max` is the distance at a point of the curves. The true maximum is larger by at most 1e-3 of
/// `max` or of the curves' mean segment, whichever is larger. Two upper bounds are used: a distance
/// changes at most as fast as its point moves, and within a face it is at most the length of the
/// way through any point or segment of the face. Intervals are halved until these bounds exclude a
/// larger maximum. `mean` is integrated by adaptive Simpson's rule to about the same accuracy.
/// Throws Error(kBadCurve) if there is no curve, a curve has no points, or two consecutive points
/// share no face; Cancelled (stage "measure").
OneSidedSurfaceDeviation one_sided_deviation(const Surface& surface,
                                             std::span<const SurfaceCurve> from,
                                             PolylineDistance& to,
                                             std::span<const SurfaceCurve> to_curves,
                                             const Progress& progress = {});

/// Measures deviations in both directions on one mesh. Holds the working memory, O(mesh), which is
/// allocated on first use. One thread at a time; the mesh must outlive the object. When the budget
/// of `progress` is used up, results are bounds (bounded_deviation.hpp).
class DeviationMeter {
 public:
  explicit DeviationMeter(const SurfaceMesh& mesh);
  ~DeviationMeter();

  /// Measures all of `result` against all of `drawn`. The curves are measured part by part; the
  /// cost of a part grows with its own distance only. Throws as one_sided_deviation() does.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, const Progress& progress = {});
  /// The same with a distance that the caller has set to `drawn`. The distance is used for all
  /// parts at once, which is cheaper if its values near the drawing have been computed.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, PolylineDistance& to_drawn,
                           const Progress& progress = {});
  /// Like the first measure(), but empty if a deviation in either direction is `limit` (mesh units)
  /// or more. Visits only faces within this distance.
  std::optional<SurfaceDeviation> measure_below(double limit, std::span<const SurfaceCurve> result,
                                                std::span<const SurfaceCurve> drawn,
                                                const Progress& progress = {});

  /// Per point, whether the curve is nearer than the point's limit (mesh units), along the surface.
  /// Visits only faces within this distance.
  std::vector<bool> are_near(std::span<const SurfacePoint> points, std::span<const double> limits,
                             const SurfaceCurve& curve);

  /// The meter's distance, which callers may use until the next measurement. A caller that sets a
  /// poller must remove the poller again.
  PolylineDistance& distance();

 private:
  const SurfaceMesh* mesh_;
  std::unique_ptr<PolylineDistance> distance_;
};

}  // namespace talweg

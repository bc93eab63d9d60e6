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

/// Distance of all points of some curves to others. Where a budget ended the measurement, `max` and
/// `mean` are bounds: the true ones are not larger.
struct OneSidedSurfaceDeviation {
  double max = 0;       ///< mesh units; infinite where no other curve can be reached
  double mean = 0;      ///< mesh units: over the length of the curves
  SurfacePoint at;      ///< the point of the curves where the distance (or its bound) is largest
  bool exact = true;    ///< whether `max` is a distance, and not a bound
  double at_least = 0;  ///< mesh units: the largest distance known; `max` if that is exact
};

/// Both directions are needed: a result that cuts a corner stays near the drawing, but the
/// drawing's corner lies far from the result.
struct SurfaceDeviation {
  OneSidedSurfaceDeviation to_drawn;    ///< of the result's points to the drawing
  OneSidedSurfaceDeviation from_drawn;  ///< of the drawing's points to the result

  /// The direction with the larger maximum.
  [[nodiscard]] const OneSidedSurfaceDeviation& larger() const {
    return to_drawn.max >= from_drawn.max ? to_drawn : from_drawn;
  }
  [[nodiscard]] bool is_exact() const { return to_drawn.exact && from_drawn.exact; }
};

/// Exact distances along the surface of every point of the segments of `from`, not only of their
/// ends, to the curves that `to` is set to, which must be `to_curves`.
///
/// `max` is the distance at a point of the curve. The true maximum is larger by at most 1e-3 of it
/// or of the curves' mean segment, whichever is more. The bounds used are that a distance changes
/// no faster than the point moves, and that within a face it is at most the distance by way of any
/// point or segment in the face; intervals are halved until these bounds rule them out. `mean` is
/// integrated by adaptive Simpson's rule to about that accuracy.
/// Throws Error(kBadCurve) when there is no curve, one has no points, or two neighbours share no
/// face; Cancelled when `progress` (stage "measure") says so.
OneSidedSurfaceDeviation one_sided_deviation(const Surface& surface,
                                             std::span<const SurfaceCurve> from,
                                             PolylineDistance& to,
                                             std::span<const SurfaceCurve> to_curves,
                                             const Progress& progress = {});

/// Measures both directions any number of times on one mesh. Holds the working memory, O(mesh),
/// which is allocated when first needed. One thread at a time; the mesh must outlive the object.
/// Where the budget of `progress` is used up, what is left is bounded: see bounded_deviation.hpp.
class DeviationMeter {
 public:
  explicit DeviationMeter(const SurfaceMesh& mesh);
  ~DeviationMeter();

  /// Measures all of `result` against all of `drawn`. It goes along the curves part by part, and
  /// each part costs what lies within its own distance. Throws as one_sided_deviation() does.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, const Progress& progress = {});
  /// The same with a distance of the caller's that is already set to `drawn`. It is used as a
  /// whole, which is cheaper where its band has been computed.
  SurfaceDeviation measure(std::span<const SurfaceCurve> result,
                           std::span<const SurfaceCurve> drawn, PolylineDistance& to_drawn,
                           const Progress& progress = {});
  /// Like the first measure(), but nothing if a deviation in either direction is `limit` (mesh
  /// units) or more. It costs only what lies nearer than that.
  std::optional<SurfaceDeviation> measure_below(double limit, std::span<const SurfaceCurve> result,
                                                std::span<const SurfaceCurve> drawn,
                                                const Progress& progress = {});

  /// For each point whether the curve comes nearer than its limit (mesh units), along the surface.
  /// It costs only what lies nearer than that.
  std::vector<bool> are_near(std::span<const SurfacePoint> points, std::span<const double> limits,
                             const SurfaceCurve& curve);

  /// What it measures with, for others to use until its next measurement. They take their poller
  /// away again.
  PolylineDistance& distance();

 private:
  const SurfaceMesh* mesh_;
  std::unique_ptr<PolylineDistance> distance_;
};

}  // namespace talweg

// Local tightening reduces the slack of a drawing near the stretches where the smoothed curve is
// too far.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Holds the working memory of tighten(), O(mesh). The surface must outlive the object. One thread
/// at a time.
class LocalTightening {
 public:
  explicit LocalTightening(const Surface& surface) : distance_(surface) {}

  /// Reduces the slack (per point of the drawing, mesh units) near the stretches where drawing and
  /// result are farther apart than `bound` (mesh units, > 0), in either direction. The slack is
  /// halved up to four times the bound along the drawing from such a stretch; from four to eight
  /// times the bound the factor rises to 1. If no stretch is beyond the bound, the farthest stretch
  /// is used. Returns the farthest point of each stretch of drawn points beyond the bound; the
  /// caller may pin these points. Distances are exact, along the surface. Throws Cancelled; the
  /// slack is then unchanged.
  std::vector<SurfacePoint> tighten(const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    double bound, std::span<double> slack,
                                    const Progress& progress = {});

 private:
  PolylineDistance distance_;
};

}  // namespace talweg

// Local tightening gives a drawing less slack where its smoothed curve lies too far away, and only
// there.
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Compares results with their drawings, stretch by stretch. Holds the working memory, O(mesh); the
/// surface must outlive the object. One thread at a time.
class LocalTightening {
 public:
  explicit LocalTightening(const Surface& surface) : distance_(surface) {}

  /// Halves the slack (per point of the drawing, mesh units) along every stretch of the drawing
  /// that lies farther than `bound` (mesh units, > 0) from the result, or beside which a part of
  /// the result lies farther from the drawing, and for four times the bound on either side. From
  /// there to twice that distance the factor rises to 1. If nothing is beyond the bound, the
  /// farthest stretch is tightened.
  /// Returns, for each stretch of points beyond the bound, the one that is farthest from the
  /// result, to be pinned where less slack does not help. Distances are exact, along the surface.
  /// Throws Cancelled when `progress` (stage "measure") says so; the slack is then unchanged.
  std::vector<SurfacePoint> tighten(const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    double bound, std::span<double> slack,
                                    const Progress& progress = {});

 private:
  PolylineDistance distance_;
};

}  // namespace talweg

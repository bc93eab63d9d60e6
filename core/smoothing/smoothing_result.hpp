// A smoothing result has the smoothed curves and a report on each.
#pragma once

#include <utility>
#include <vector>

#include "talweg/core/measure/report.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The result of smooth(). References into the result are valid as long as it lives.
struct SmoothingResult {
  std::vector<SurfaceCurve> curves;      ///< one per drawn curve, in drawn order
  std::vector<SmoothingReport> reports;  ///< one per curve, in drawn order
  SmoothingReport total;                 ///< of all curves

  /// The first curve, or the only one.
  [[nodiscard]] const SurfaceCurve& curve() const& { return curves.front(); }
  [[nodiscard]] SurfaceCurve curve() && { return std::move(curves.front()); }
  /// The report on all curves together.
  [[nodiscard]] const SmoothingReport& report() const& { return total; }
  [[nodiscard]] SmoothingReport report() && { return std::move(total); }
};

}  // namespace talweg

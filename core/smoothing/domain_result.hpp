// A domain result has the smoothed curves, and those values of their reports that are known during
// smoothing only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct CurveResult {
  SurfaceCurve curve;
  StraightenedPath path;
  bool has_legs = false;              ///< the result may be far from the drawing there
  bool ended_early = false;           ///< a budget ended fairing
  double slack = 0;                   ///< mesh units; 0 without a corridor
  MeasuredDeviation deviation;        ///< measured on the domain's surface
  std::vector<std::string> warnings;  ///< sentences about this curve
  std::string left_taut;              ///< a sentence, if the curve stays taut with kinks
  std::size_t crossings_before = 0, crossings_after = 0;  ///< with itself and later curves
};

struct DomainResult {
  std::vector<CurveResult> curves;  ///< one per curve of the drawing, in order
  PotentialKind potential = PotentialKind::kPaper;
  Engine engine = Engine::kFull;
  StraighteningCounts counts;
  double mollification = 0;  ///< mesh units
  /// The smooth ground on which the curves were faired; null for the mesh itself.
  const SurfaceMesh* ground = nullptr;
  std::vector<std::string> warnings;  ///< sentences for the user
  /// `open`: the time beyond opening the mesh; `measure`: the time on the domain's surface; `total`
  /// is not set.
  StageTimes time_ms;
  /// Whether straightening touched the boundary where the surface was cut off
  /// (EmbeddedDrawing::Ground).
  bool at_fence = false;
};

/// Copies the counts and times of a straightening to a result.
inline void report_straightening(const Straightened& straight, DomainResult& smoothed) {
  for (std::size_t c = 0; c < straight.paths.size(); ++c) {
    smoothed.curves[c].path = straight.paths[c];
  }
  smoothed.counts = straight.counts;
  smoothed.time_ms = straight.time_ms;
  smoothed.at_fence = straight.at_fence;
}

/// The straightened curves as a result.
inline DomainResult domain_result_from(Straightened straight) {
  DomainResult smoothed;
  for (SurfaceCurve& curve : straight.curves) {
    smoothed.curves.emplace_back().curve = std::move(curve);
  }
  report_straightening(straight, smoothed);
  return smoothed;
}

/// DomainResult curves converted to the order and direction of the drawn curves.
inline DomainResult as_drawn(const OrderedDrawing& drawing, DomainResult smoothed) {
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    SurfaceCurve& curve = smoothed.curves[c].curve;
    curve = drawing.in_drawn_direction(c, std::move(curve));
  }
  smoothed.curves = drawing.in_drawn_order(smoothed.curves);
  return smoothed;
}

}  // namespace talweg

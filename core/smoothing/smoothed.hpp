// Smoothed curves carry what a report says of them and only their smoothing knows.
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
  bool has_legs = false;                                  ///< may lead far from its drawing there
  bool ended_early = false;                               ///< fairing, by a budget
  double slack = 0;                                       ///< mesh units; 0 without a corridor
  MeasuredDeviation deviation;                            ///< on the surface where it was smoothed
  std::vector<std::string> warnings;                      ///< sentences about this curve
  std::string left_taut;                                  ///< a sentence, where it is, with kinks
  std::size_t crossings_before = 0, crossings_after = 0;  ///< with itself and later curves
};

struct DomainResult {
  std::vector<CurveResult> curves;  ///< one for each curve of the drawing, in their order
  PotentialKind potential = PotentialKind::kPaper;
  Engine engine = Engine::kFull;
  StraighteningCounts counts;
  double mollification = 0;  ///< mesh units
  /// The ground on which the curves are fair, where that is not the mesh; else null.
  const SurfaceMesh* ground = nullptr;
  std::vector<std::string> warnings;  ///< sentences for the user
  /// `open`: the time beyond opening the mesh; `measure` that on the surface where it was smoothed;
  /// the total is not set.
  StageTimes time_ms;
  /// Whether a result touched the boundary where its part of the surface was cut off: see
  /// EmbeddedDrawing::Ground.
  bool at_fence = false;
};

/// Says in a result what the straightening did that it needed.
inline void report_straightening(const Straightened& straight, DomainResult& smoothed) {
  for (std::size_t c = 0; c < straight.paths.size(); ++c) {
    smoothed.curves[c].path = straight.paths[c];
  }
  smoothed.counts = straight.counts;
  smoothed.time_ms = straight.time_ms;
  smoothed.at_fence = straight.at_fence;
}

/// The result of a straightening.
inline DomainResult domain_result_from(Straightened straight) {
  DomainResult smoothed;
  for (SurfaceCurve& curve : straight.curves) {
    smoothed.curves.emplace_back().curve = std::move(curve);
  }
  report_straightening(straight, smoothed);
  return smoothed;
}

/// Smoothed curves in the order and direction in which the drawing had them.
inline DomainResult as_drawn(const OrderedDrawing& drawing, DomainResult smoothed) {
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    SurfaceCurve& curve = smoothed.curves[c].curve;
    curve = drawing.in_drawn_direction(c, std::move(curve));
  }
  smoothed.curves = drawing.in_drawn_order(smoothed.curves);
  return smoothed;
}

}  // namespace talweg

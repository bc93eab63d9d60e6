#include "talweg/core/smoothing/mesh_domain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/smoothing/drawing_deviation.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
MeshDomain::MeshDomain(SmoothingMemory& memory, const OrderedDrawing& drawing,
                       const CurveOptions& options, EmbeddedDrawing::Ground ground,
                       const Progress& progress)
    : memory_(&memory), drawing_(memory, drawing, options, ground, progress) {
  if (options.method == Method::kCorridor) {
    corridor_.emplace(memory, drawing_);
  } else {
    paper_.emplace(memory.opened(), drawing_);
  }
}

bool MeshDomain::let_cross(std::size_t crossings, const Progress& progress) {
  return corridor_ && drawing_.let_legs_cross(crossings, progress);
}

void MeshDomain::count_crossings(DomainResult& result, const Progress& progress) {
  const OrderedDrawing& drawing = drawing_.drawing();
  Straightening& straightening = memory_->straightening();
  straightening.clear();  // removes embedded legs
  if (crossings_.empty()) crossings_ = straightening.crossings_of(drawing.drawn(), progress);
  std::vector<SurfaceCurve> curves;
  for (const CurveResult& curve : result.curves) curves.push_back(curve.curve);
  const std::vector<std::size_t> after =
      straightening.crossings_of(drawing.in_drawn_order(curves), progress);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    result.curves[c].crossings_before = crossings_[drawing.numbers()[c]];
    result.curves[c].crossings_after = after[drawing.numbers()[c]];
  }
}

void MeshDomain::solve(const Progress& progress) {
  const Stopwatch watch;
  if (corridor_) corridor_->solve(progress);
  if (paper_ && drawing_.options().distance_at_once) paper_->need_distance(progress);
  if (corridor_) solve_ms_ = watch.ms();
}

void MeshDomain::set_distance(std::vector<double> distance) {
  paper_->set_distance(std::move(distance));
}

void MeshDomain::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  drawing_.set_pins({pins.begin(), pins.end()}, progress);
  if (corridor_) corridor_->pins_changed();
}

std::vector<double> MeshDomain::slack() const {
  std::vector<double> slack;
  if (!corridor_) return slack;
  for (const Corridor::Valley& valley : corridor_->valleys()) slack.push_back(valley.slack);
  return slack;
}

std::span<const double> MeshDomain::distance() const {
  return paper_ ? paper_->lift().distance() : std::span<const double>{};
}

void MeshDomain::need_distance(const Progress& progress) {
  if (paper_) paper_->need_distance(progress);
}

DomainResult MeshDomain::smooth(const SmoothingOptions& options, const GivenPotential* given,
                                const Progress& progress) {
  DomainResult result = curves(options, given, progress);
  measure(options, result, progress);
  return result;
}

DomainResult MeshDomain::curves(const SmoothingOptions& options, const GivenPotential* given,
                                const Progress& progress) {
  // A given potential has no effect on crossing legs, which are never straightened together.
  const bool lifted = given != nullptr && !drawing_.may_cross();
  DomainResult result = lifted      ? smooth_in(drawing_, *given, options, progress)
                        : corridor_ ? corridor_->smooth(options, progress)
                                    : paper_->smooth(options, progress);
  result.time_ms.solve = solve_ms_;
  if (drawing_.may_cross()) count_crossings(result, progress);
  if (corridor_ && !lifted) warn_of_upper_bounds(result);
  if (paper_) {
    result.time_ms.open = paper_->lift().open_ms();
    result.time_ms.solve = paper_->lift().solve_ms();
    result.mollification = paper_->lift().mollification();
    result.warnings = paper_->lift().warnings();
  }
  return result;
}

/// Warns if the distance was exact only within less than the slack.
void MeshDomain::warn_of_upper_bounds(DomainResult& result) const {
  const double exact = memory_->distance().exact_within();
  double slack = 0;
  for (const CurveResult& curve : result.curves) slack = std::max(slack, curve.slack);
  if (exact >= slack) return;
  result.warnings.push_back(
      fmt::format("Distances of more than {:.4g} to the drawing are upper bounds, because exact "
                  "distances would take too long; with exact distances the result might differ.",
                  exact));
}

void MeshDomain::measure(const SmoothingOptions& options, DomainResult& smoothed,
                         const Progress& progress) {
  const bool band_is_there = corridor_ && drawing_.drawing().curves().size() == 1 &&
                             !drawing_.any_legs() && std::isinf(memory_->distance().exact_within());
  measure_deviations(*memory_, drawing_.drawing(), drawing_.legs(), options,
                     band_is_there ? &memory_->distance() : nullptr, smoothed, progress);
}

}  // namespace talweg

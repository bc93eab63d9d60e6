#include "talweg/core/smoothing/whole_sheet.hpp"

#include <utility>

#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {

WholeSheet::WholeSheet(SmoothingMemory& memory, const OrderedDrawing& drawing,
                       const CurveOptions& options, EmbeddedDrawing::Ground ground,
                       const Progress& progress)
    : memory_(&memory), drawing_(memory, drawing, options, ground, progress) {
  if (options.method == Method::kCorridor) {
    corridor_.emplace(memory, drawing_);
  } else {
    paper_.emplace(memory.opened(), drawing_);
  }
}

void WholeSheet::solve(const Progress& progress) {
  const Stopwatch watch;
  if (corridor_) corridor_->solve(progress);
  if (paper_ && drawing_.options().distance_at_once) paper_->need_distance(progress);
  if (corridor_) solve_ms_ = watch.ms();
}

void WholeSheet::set_distance(std::vector<double> distance) {
  paper_->set_distance(std::move(distance));
}

void WholeSheet::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  drawing_.set_pins({pins.begin(), pins.end()}, progress);
  if (corridor_) corridor_->pins_changed();
}

std::vector<double> WholeSheet::slack() const {
  std::vector<double> slack;
  if (!corridor_) return slack;
  for (const Corridor::Valley& valley : corridor_->valleys()) slack.push_back(valley.slack);
  return slack;
}

std::span<const double> WholeSheet::distance() const {
  return paper_ ? paper_->lift().distance() : std::span<const double>{};
}

void WholeSheet::need_distance(const Progress& progress) {
  if (paper_) paper_->need_distance(progress);
}

Smoothed WholeSheet::smooth(const SmoothingOptions& options, const GivenPotential* given,
                            const Progress& progress) {
  Smoothed result = given != nullptr ? smooth_in(drawing_, *given, options, progress)
                    : corridor_      ? corridor_->smooth(options, progress)
                                     : paper_->smooth(options, progress);
  result.time_ms.solve = solve_ms_;
  if (paper_) {
    result.time_ms.open = paper_->lift().open_ms();
    result.time_ms.solve = paper_->lift().solve_ms();
    result.mollification = paper_->lift().mollification();
    result.warnings = paper_->lift().warnings();
  }
  result.at_fence = drawing_.came_to_fence();
  measure(options, result, progress);
  return result;
}

void WholeSheet::measure(const SmoothingOptions& options, Smoothed& smoothed,
                         const Progress& progress) {
  const OrderedDrawing& drawing = drawing_.drawing();
  const bool band_is_there = corridor_ && drawing.curves().size() == 1 && !drawing_.all_legs();
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    SmoothedCurve& curve = smoothed.curves[c];
    curve.deviation = measure_deviation(
        options.deviation_measure(c), drawing.edges_near()[c], memory_->meter(), drawing_.mesh(),
        drawing.curves()[c], curve.curve, band_is_there ? &memory_->distance() : nullptr, progress);
  }
}

}  // namespace talweg

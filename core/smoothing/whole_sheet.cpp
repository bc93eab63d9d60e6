#include "talweg/core/smoothing/whole_sheet.hpp"

#include <algorithm>
#include <utility>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/leg_start.hpp"
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

/// A leg is nowhere near its drawing, so only strokes count where there are any.
MeasuredDeviation WholeSheet::deviation_of(std::size_t curve, const SurfaceCurve& result,
                                           DeviationMeasure measure, const Progress& progress) {
  if (measure == DeviationMeasure::kNone) return {};
  const OrderedDrawing& drawing = drawing_.drawing();
  const SurfaceCurve& drawn = drawing.curves()[curve];
  const DrawnLegs& legs = drawing_.legs()[curve];
  const bool mixed = legs.any() && !legs.all();
  std::vector<SurfaceCurve> from{result}, to{drawn};
  if (mixed) from = strokes_of(legs, result);
  if (mixed) to = strokes_of(legs, drawn);
  if (from.size() != to.size()) from = {result}, to = {drawn};
  const bool band_is_there = corridor_ && drawing.curves().size() == 1 && !legs.any();
  MeasuredDeviation all;
  double lengths = 0, drawn_lengths = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    MeasuredDeviation one =
        measure_deviation(measure, drawing.edges_near()[curve], memory_->meter(), drawing_.mesh(),
                          to[k], from[k], band_is_there ? &memory_->distance() : nullptr, progress);
    if (from.size() == 1) return one;
    const double length = curve_length(drawing_.surface(), from[k]),
                 drawn_length = curve_length(drawing_.surface(), to[k]);
    one.to_drawn_mean *= length;
    one.from_drawn_mean *= drawn_length;
    lengths += length;
    drawn_lengths += drawn_length;
    if (k == 0) {
      all = one;
      continue;
    }
    if (std::max(one.to_drawn_max, one.from_drawn_max) >
        std::max(all.to_drawn_max, all.from_drawn_max)) {
      all.at = one.at;
    }
    all.to_drawn_max = std::max(all.to_drawn_max, one.to_drawn_max);
    all.from_drawn_max = std::max(all.from_drawn_max, one.from_drawn_max);
    all.to_drawn_mean += one.to_drawn_mean;
    all.from_drawn_mean += one.from_drawn_mean;
  }
  all.to_drawn_mean /= lengths;
  all.from_drawn_mean /= drawn_lengths;
  return all;
}

void WholeSheet::measure(const SmoothingOptions& options, Smoothed& smoothed,
                         const Progress& progress) {
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    SmoothedCurve& curve = smoothed.curves[c];
    curve.deviation = deviation_of(c, curve.curve, options.deviation_measure(c), progress);
  }
}

}  // namespace talweg

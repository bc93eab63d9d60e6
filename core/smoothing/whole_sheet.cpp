#include "talweg/core/smoothing/whole_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

// Of measuring, where the caller leaves it to us: about as long as smoothing takes.
constexpr std::uint64_t kMostWork = 500'000, kMostWorkOfPoint = 700;

/// Of several strokes: the largest of their deviations, and their means weighted by length.
class StrokesDeviation {
 public:
  void add(const MeasuredDeviation& one, double drawn_length, double length) {
    const auto farthest = [](const MeasuredDeviation& of) {
      return std::max(of.to_drawn_max, of.from_drawn_max);
    };
    if (length_ + drawn_length_ == 0) {
      all_ = one;
    } else {
      if (farthest(one) > farthest(all_)) all_.at = one.at;
      all_.exact = all_.exact && one.exact;
      all_.at_least = std::max(all_.at_least, one.at_least);
      all_.to_drawn_max = std::max(all_.to_drawn_max, one.to_drawn_max);
      all_.from_drawn_max = std::max(all_.from_drawn_max, one.from_drawn_max);
      all_.to_drawn_mean = mean(all_.to_drawn_mean, length_, one.to_drawn_mean, length);
      all_.from_drawn_mean =
          mean(all_.from_drawn_mean, drawn_length_, one.from_drawn_mean, drawn_length);
    }
    length_ += length;
    drawn_length_ += drawn_length;
  }
  [[nodiscard]] const MeasuredDeviation& get() const { return all_; }

 private:
  static double mean(double a, double of_a, double b, double of_b) {
    if (of_a == 0 || of_b == 0) return of_a == 0 ? b : a;
    return a * (of_a / (of_a + of_b)) + b * (of_b / (of_a + of_b));
  }
  MeasuredDeviation all_;
  double length_ = 0, drawn_length_ = 0;
};

}  // namespace

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

bool WholeSheet::let_cross(std::size_t crossings, const Progress& progress) {
  return corridor_ && drawing_.let_legs_cross(crossings, progress);
}

void WholeSheet::count_crossings(Smoothed& result, const Progress& progress) {
  const OrderedDrawing& drawing = drawing_.drawing();
  Straightening& straightening = memory_->straightening();
  straightening.clear();  // of legs, which are embedded one by one
  if (crossings_.empty()) crossings_ = straightening.crossings_of(drawing.drawn(), progress);
  std::vector<SurfaceCurve> curves;
  for (const SmoothedCurve& curve : result.curves) curves.push_back(curve.curve);
  const std::vector<std::size_t> after =
      straightening.crossings_of(drawing.in_drawn_order(curves), progress);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    result.curves[c].crossings_before = crossings_[drawing.numbers()[c]];
    result.curves[c].crossings_after = after[drawing.numbers()[c]];
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
  Smoothed result = curves(options, given, progress);
  measure(options, result, progress);
  return result;
}

Smoothed WholeSheet::curves(const SmoothingOptions& options, const GivenPotential* given,
                            const Progress& progress) {
  // Nothing holds legs, and those that cross are never straightened together.
  const bool lifted = given != nullptr && !drawing_.may_cross();
  Smoothed result = lifted      ? smooth_in(drawing_, *given, options, progress)
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

/// Told here, since a corridor's trials look for other warnings.
void WholeSheet::warn_of_upper_bounds(Smoothed& result) const {
  const double exact = memory_->distance().exact_within();
  double slack = 0;
  for (const SmoothedCurve& curve : result.curves) slack = std::max(slack, curve.slack);
  if (exact >= slack) return;
  result.warnings.push_back(
      fmt::format("Exact distances would take far too long here: farther than {:.4g} from the "
                  "drawing they were taken longer than they are, and the result may be another one "
                  "than with them.",
                  exact));
}

/// A leg is nowhere near its drawing, so only strokes count where there are any.
MeasuredDeviation WholeSheet::deviation_of(std::size_t curve, const SurfaceCurve& result,
                                           DeviationMeasure measure, const Progress& progress) {
  const OrderedDrawing& drawing = drawing_.drawing();
  const SurfaceCurve& drawn = drawing.curves()[curve];
  const DrawnLegs& legs = drawing_.legs()[curve];
  const auto between = [&](const SurfaceCurve& from, const SurfaceCurve& to,
                           PolylineDistance* distance) {
    return measure_deviation(measure, drawing.edges_near()[curve], memory_->meter(),
                             drawing_.mesh(), from, to, distance, progress);
  };
  const bool mixed = measure != DeviationMeasure::kNone && legs.any() && !legs.all();
  const std::vector<SurfaceCurve> from = mixed ? strokes_of(legs, drawn) : std::vector{drawn};
  const std::vector<SurfaceCurve> to = mixed ? strokes_of(legs, result) : std::vector{result};
  if (from.size() == 1 || from.size() != to.size()) {
    const bool whole = from.size() != to.size();
    const bool band_is_there = corridor_ && drawing.curves().size() == 1 && !legs.any() &&
                               std::isinf(memory_->distance().exact_within());
    return between(whole ? drawn : from[0], whole ? result : to[0],
                   band_is_there ? &memory_->distance() : nullptr);
  }
  StrokesDeviation all;
  for (std::size_t k = 0; k < from.size(); ++k) {
    all.add(between(from[k], to[k], nullptr), curve_length(drawing_.surface(), from[k]),
            curve_length(drawing_.surface(), to[k]));
  }
  return all.get();
}

void WholeSheet::measure(const SmoothingOptions& options, Smoothed& smoothed,
                         const Progress& progress) {
  const Stopwatch watch;
  // A budget of the caller's says how long measuring may take.
  const bool spares =
      options.deviation == DeviationMeasure::kAutomatic && progress.budget() == nullptr;
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    SmoothedCurve& curve = smoothed.curves[c];
    const std::size_t points = drawing_.drawing().curves()[c].points.size();
    Budget own;
    if (spares) own.work = kMostWork + kMostWorkOfPoint * (points + curve.curve.points.size());
    curve.deviation = deviation_of(c, curve.curve, options.deviation_measure(c),
                                   spares ? progress.with(own) : progress);
    curve.deviation.spared = spares && !curve.deviation.exact;
  }
  smoothed.time_ms.measure = watch.ms();
}

}  // namespace talweg

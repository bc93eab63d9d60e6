#include "talweg/core/smoothing/drawing_deviation.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

// The work of measuring under kAutomatic without a budget: about as long as smoothing takes.
constexpr std::uint64_t kMostWork = 500'000, kMostWorkOfPoint = 700;

/// Combines the deviations of several strokes: maxima, and means weighted by length.
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

MeasuredDeviation deviation_of(SmoothingMemory& memory, const SurfaceCurve& drawn, double edge,
                               const DrawnLegs& legs, const SurfaceCurve& result,
                               DeviationMeasure measure, PolylineDistance* band,
                               const Progress& progress) {
  const auto between = [&](const SurfaceCurve& from, const SurfaceCurve& to,
                           PolylineDistance* distance) {
    return measure_deviation(measure, edge, memory.meter(), memory.mesh(), from, to, distance,
                             progress);
  };
  const bool mixed = measure != DeviationMeasure::kNone && legs.any() && !legs.all();
  const std::vector<SurfaceCurve> from = mixed ? strokes_of(legs, drawn) : std::vector{drawn};
  const std::vector<SurfaceCurve> to = mixed ? strokes_of(legs, result) : std::vector{result};
  // A result that misses a point between legs and strokes cannot be divided into strokes.
  const bool lost = mixed && to.size() == 1 && to[0].points.size() == result.points.size();
  if (from.size() == 1 || from.size() != to.size()) {
    const bool whole = lost || from.size() != to.size();
    return between(whole ? drawn : from[0], whole ? result : to[0], band);
  }
  StrokesDeviation all;
  for (std::size_t k = 0; k < from.size(); ++k) {
    all.add(between(from[k], to[k], nullptr), curve_length(memory.surface(), from[k]),
            curve_length(memory.surface(), to[k]));
  }
  return all.get();
}

}  // namespace

void measure_deviations(SmoothingMemory& memory, const OrderedDrawing& drawing,
                        std::span<const DrawnLegs> legs, const SmoothingOptions& options,
                        PolylineDistance* band, DomainResult& smoothed, const Progress& progress) {
  const Stopwatch watch;
  // A budget of the caller limits measuring already.
  const bool spares =
      options.deviation == DeviationMeasure::kAutomatic && progress.budget() == nullptr;
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    CurveResult& curve = smoothed.curves[c];
    const SurfaceCurve& drawn = drawing.curves()[c];
    Budget own;
    if (spares) {
      own.work = kMostWork + kMostWorkOfPoint * (drawn.points.size() + curve.curve.points.size());
    }
    curve.deviation =
        deviation_of(memory, drawn, drawing.edges_near()[c], legs[c], curve.curve,
                     options.deviation_measure(c), band, spares ? progress.with(own) : progress);
    curve.deviation.spared = spares && !curve.deviation.exact;
  }
  smoothed.time_ms.measure = watch.ms();
}

}  // namespace talweg

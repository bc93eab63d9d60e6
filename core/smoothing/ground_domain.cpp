#include "talweg/core/smoothing/ground_domain.hpp"

#include <utility>

#include "talweg/core/smoothing/domain_choice.hpp"
#include "talweg/core/smoothing/drawing_deviation.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {

GroundDomain::GroundDomain(SmoothingMemory& memory, const OrderedDrawing& drawing,
                           CurveOptions options, const Progress& progress)
    : memory_(&memory), drawing_(&drawing), options_(std::move(options)) {
  const Stopwatch watch;
  SmoothingMemory& ground = memory_->ground(progress);
  there_ = checked_drawing(ground.mesh(), drawing.curves(), drawing.slacks(), options_, progress);
  ground_ = domain_on(ground, there_, options_, std::nullopt, progress);
  solve_ms_ = watch.ms();
}

bool GroundDomain::is_fair(const SmoothingOptions& options) const {
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    if (options.finish_of(c) != Finish::kFair || options.tau_of(c) == 0) return false;
  }
  return options.relax_rounds == 0;
}

SmoothingDomain& GroundDomain::as_it_is(const Progress& progress) {
  if (!as_it_is_) as_it_is_ = domain_on(*memory_, *drawing_, options_, std::nullopt, progress);
  return *as_it_is_;
}

DomainResult GroundDomain::smooth(const SmoothingOptions& options, const GivenPotential* given,
                                  const Progress& progress) {
  if (given != nullptr || !is_fair(options)) {
    return as_it_is(progress).smooth(options, given, progress);
  }
  SmoothingOptions own = options;
  own.deviation = DeviationMeasure::kNone;
  DomainResult result =
      as_drawn(there_, ground_->smooth(there_.ordered(std::move(own)), nullptr, progress));
  result.ground = &memory_->ground(progress).mesh();
  result.time_ms.solve = solve_ms_;
  measure_deviations(*memory_, *drawing_, legs(), options, nullptr, result, progress);
  return result;
}

std::vector<DrawnLegs> GroundDomain::legs() const {
  std::vector<SurfacePoint> fixed = options_.pins;
  fixed.insert(fixed.end(), options_.corners.begin(), options_.corners.end());
  std::vector<DrawnLegs> legs;
  for (const SurfaceCurve& curve : drawing_->curves()) {
    legs.push_back(legs_of(curve, fixed, options_.way_points, options_.painted));
  }
  return legs;
}

void GroundDomain::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  options_.pins.assign(pins.begin(), pins.end());
  ground_->set_pins(pins, progress);
  if (as_it_is_) as_it_is_->set_pins(pins, progress);
}

std::vector<double> GroundDomain::slack() const { return there_.in_drawn_order(ground_->slack()); }

}  // namespace talweg

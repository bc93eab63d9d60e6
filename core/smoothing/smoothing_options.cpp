#include "talweg/core/smoothing/smoothing_options.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "talweg/core/lifting/relaxation.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

[[noreturn]] void out_of_range(const std::string& message) {
  throw Error(ErrorCode::kBadUsage, message);
}

bool is_bounded(double value) { return value >= 0 && std::isfinite(value); }

}  // namespace

void CurveOptions::validate() const {
  if (threads < 1) out_of_range("threads must be >= 1.");
  if (!(heat_time >= 1e-3 && heat_time <= 1e6)) out_of_range("heat_time must be in [1e-3, 1e6].");
  if (bump_radius && !(*bump_radius > 0 && std::isfinite(*bump_radius))) {
    out_of_range("bump_radius must be finite and > 0.");
  }
  if (click_distance && !(*click_distance >= 0 && std::isfinite(*click_distance))) {
    out_of_range("click_distance must be finite and >= 0.");
  }
  for (const WayPoint& way_point : way_points) {
    if (way_point.tolerance >= 0 && std::isfinite(way_point.tolerance)) continue;
    out_of_range("The tolerance of a way-point must be finite and >= 0.");
  }
}

double SmoothingOptions::tau_of(std::size_t curve) const {
  return curve < per_curve.size() ? per_curve[curve].tau.value_or(tau) : tau;
}

std::optional<double> SmoothingOptions::slack_of(std::size_t curve) const {
  return curve < per_curve.size() && per_curve[curve].slack ? per_curve[curve].slack : slack;
}

Finish SmoothingOptions::finish_of(std::size_t curve) const {
  return curve < per_curve.size() ? per_curve[curve].finish.value_or(finish) : finish;
}

SmoothingOptions SmoothingOptions::of(std::size_t curve) const {
  SmoothingOptions own = *this;
  own.per_curve.clear();
  own.slack_at.clear();
  own.tau = tau_of(curve);
  own.slack = slack_of(curve);
  own.finish = finish_of(curve);
  return own;
}

DeviationMeasure SmoothingOptions::deviation_measure(std::size_t curve) const {
  const bool near = deviation == DeviationMeasure::kAutomatic && tau_of(curve) >= kLeastHeldTau;
  return near ? DeviationMeasure::kAlongSurface : deviation;
}

void SmoothingOptions::validate() const {
  if (!is_bounded(tau)) out_of_range("tau must be finite and >= 0.");
  potential.validate();
  RelaxationOptions{relax_rounds}.validate();
  if (!(min_relative_length >= 0 && min_relative_length < 1)) {
    out_of_range("min_relative_length must be in [0, 1).");
  }
  if (slack && !is_bounded(*slack)) out_of_range("slack must be finite and >= 0.");
  for (std::size_t c = 0; c < per_curve.size(); ++c) {
    const auto check = [c](const std::optional<double>& value, const char* field) {
      if (!value || is_bounded(*value)) return;
      out_of_range(fmt::format("per_curve[{}].{} must be finite and >= 0.", c, field));
    };
    check(per_curve[c].tau, "tau");
    check(per_curve[c].slack, "slack");
  }
  if (phase_turns < 0 || phase_turns > 64) out_of_range("phase_turns must be in [0, 64].");
  if (length_floor && !(*length_floor >= 0 && std::isfinite(*length_floor))) {
    out_of_range("length_floor must be finite and >= 0.");
  }
  budget.validate();
}

}  // namespace talweg

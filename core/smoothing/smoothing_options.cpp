#include "talweg/core/smoothing/smoothing_options.hpp"

#include <cmath>
#include <string>

#include "talweg/core/smoothing/relaxation.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

[[noreturn]] void out_of_range(const std::string& message) {
  throw Error(ErrorCode::kBadUsage, message);
}

}  // namespace

void CurveOptions::validate() const {
  if (threads < 1) out_of_range("threads must be >= 1.");
  if (!(heat_time >= 1e-3 && heat_time <= 1e6)) out_of_range("heat_time must be in [1e-3, 1e6].");
  if (bump_radius && !(*bump_radius > 0 && std::isfinite(*bump_radius))) {
    out_of_range("bump_radius must be finite and > 0.");
  }
  for (const WayPoint& way_point : way_points) {
    if (way_point.tolerance >= 0 && std::isfinite(way_point.tolerance)) continue;
    out_of_range("The tolerance of a way-point must be finite and >= 0.");
  }
}

void SmoothingOptions::validate() const {
  if (!(tau >= 0 && std::isfinite(tau))) out_of_range("tau must be finite and >= 0.");
  potential.validate();
  RelaxationOptions{relax_rounds}.validate();
  if (!(min_relative_length >= 0 && min_relative_length < 1)) {
    out_of_range("min_relative_length must be in [0, 1).");
  }
  if (slack && !(*slack >= 0 && std::isfinite(*slack)))
    out_of_range("slack must be finite and >= 0.");
  if (phase_turns < 0 || phase_turns > 64) out_of_range("phase_turns must be in [0, 64].");
  if (length_floor && !(*length_floor >= 0 && std::isfinite(*length_floor))) {
    out_of_range("length_floor must be finite and >= 0.");
  }
}

}  // namespace talweg

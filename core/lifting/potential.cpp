#include "talweg/core/lifting/potential.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

void require(bool good, const std::string& message) {
  if (!good) throw Error(ErrorCode::kBadUsage, message);
}

}  // namespace

void PotentialOptions::validate() const {
  require(exponent >= 1 && exponent <= 16, "The potential's exponent must be in [1, 16].");
  require(gain > 0 && std::isfinite(gain), "The potential's gain must be finite and > 0.");
  require(length != Length::kGiven || (given_length > 0 && std::isfinite(given_length)),
          "The potential's characteristic length must be finite and > 0.");
}

Potential::Potential(const PotentialOptions& options, double tau, double characteristic_length)
    : options_(options), scale_(0), length_(characteristic_length) {
  options.validate();
  require(tau >= 0 && std::isfinite(tau), "tau must be finite and >= 0.");
  require(length_ > 0 && std::isfinite(length_),
          "The characteristic length of the potential must be finite and > 0.");
  scale_ = options.gain * tau / length_;
}

double Potential::operator()(double distance) const {
  if (!std::isfinite(distance)) return 0;
  const double x = std::abs(scale_ * distance);
  double f = 0;
  if (options_.shape == PotentialOptions::Shape::kExponential) {
    f = std::expm1(std::min(x, 230.0));
  } else {
    f = options_.exponent == 2 ? x * x : std::pow(x, options_.exponent);
  }
  constexpr double kCut = 1e100;  // its square is still finite
  return length_ * std::min(f, kCut);
}

}  // namespace talweg

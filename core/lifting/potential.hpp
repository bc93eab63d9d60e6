// The paper's penalty potentials grow with the distance.
#pragma once

#include <optional>

namespace talweg {

/// The settings of the heat distance, of which the potential is a function.
struct HeatSettings {
  double time = 10;      ///< in units of h²; [1e-3, 1e6]
  unsigned threads = 2;  ///< at most; >= 1; no effect on results
  /// Unless empty, the distance is convolved with a bump of this radius, mesh units: see
  /// BumpOptions.
  std::optional<double> bump_radius;
};

/// m_tau(x) = L f(a tau x / L), equations 4 to 6 of the paper. The defaults are the paper's.
struct PotentialOptions {
  /// The function f.
  enum class Shape {
    kPower,        ///< f(x) = x^exponent
    kExponential,  ///< f(x) = e^x - 1
  };
  /// The choice of the characteristic length L.
  enum class Length {
    kMaximumDistance,  ///< L = max δ over the components that have a curve
    kCurveLength,      ///< L = total length of the drawn curves
    kGiven,            ///< L = given_length
  };
  Shape shape = Shape::kPower;               ///< of f
  double exponent = 2;                       ///< in [1, 16]
  double gain = 10;                          ///< a; finite, > 0
  Length length = Length::kMaximumDistance;  ///< which length L is
  double given_length = 0;                   ///< mesh units; > 0 where used

  /// Throws Error(kBadUsage) naming the field and its bound.
  void validate() const;
};

/// φ as a function of the distance. O(1).
class Potential {
 public:
  /// tau in [0, infinity), characteristic_length L > 0 in mesh units.
  /// Throws Error(kBadUsage) naming what is out of range.
  Potential(const PotentialOptions& options, double tau, double characteristic_length);

  /// Mesh units. Even in the distance; 0 at 0. Always finite: values beyond 1e100 L are cut off
  /// there, and the value is 0 where the distance is infinite, so that components without a curve
  /// stay flat.
  double operator()(double distance) const;
  [[nodiscard]] double characteristic_length() const { return length_; }

 private:
  PotentialOptions options_;
  double scale_;  // a tau / L
  double length_;
};

}  // namespace talweg

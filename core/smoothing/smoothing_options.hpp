// The options of a drawing and of its smoothing have units, ranges and defaults.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/measure/deviation_measure.hpp"
#include "talweg/core/smoothing/potential.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Which potential holds the curve, and with it which distance is measured.
enum class Method {
  kPaper,     ///< equations 4 to 6 over the heat method's distance on the whole mesh
  kCorridor,  ///< flat within the slack, exact distance in a band, phase for loops, polished
};

/// What setting a curve depends on.
struct CurveOptions {
  Method method = Method::kCorridor;  ///< and with it the distance
  double heat_time = 10;              ///< of the distance's heat flow, in units of h²; [1e-3, 1e6]
  /// Whether the paper's distance, which is what setting a curve costs, is there when it is set;
  /// else it is computed when something first needs it, and at tau = 0 nothing does.
  bool distance_at_once = true;
  /// Mesh units, > 0: the distance is smoothed once more by equation 3, within this radius.
  std::optional<double> bump_radius;
  bool cap_corners = true;  ///< as the paper does; only curves that run along mesh edges
  unsigned threads = 2;  ///< at most, for the factors of the heat distance; >= 1; changes no result
  std::vector<SurfacePoint> pins;  ///< points of the drawing that the result must pass through

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// From this tau on a result keeps near its drawing; below it may lead anywhere.
constexpr double kLeastHeldTau = 1.0 / 8;

/// What a new tau depends on.
struct SmoothingOptions {
  double tau = 1;  ///< [0, infinity): 0 gives geodesics, more keeps closer to the drawing
  PotentialOptions potential;   ///< of the paper's method
  std::optional<double> slack;  ///< of the corridor, mesh units, >= 0; see CurveSmoother::slack()
  /// Unless empty, the corridor's slack along the drawing instead: per drawn curve one value per
  /// point, mesh units, >= 0, linear in between. See slack_along().
  std::vector<std::vector<double>> slack_at;
  int phase_turns = 3;   ///< of the corridor's phase around a loop, at most points / 8; [0, 64]
  bool polish = true;    ///< the corridor's result
  int relax_rounds = 0;  ///< of the paper's relaxation; its authors use 5
  std::optional<std::size_t> max_iterations;  ///< of FlipOut; by default its own bound
  double min_relative_length = 0;  ///< stop at this fraction of the lifted length; [0, 1)
  /// Mesh units; by default 3 mean edges of the drawn loop, at most half of its length.
  std::optional<double> length_floor;
  /// Between result and drawing, for the report.
  DeviationMeasure deviation = DeviationMeasure::kAutomatic;
  bool prepare_whole_mesh = false;  ///< lay out everything first; slower, same result

  /// What `deviation` means for this tau.
  [[nodiscard]] DeviationMeasure deviation_measure() const {
    const bool near = deviation == DeviationMeasure::kAutomatic && tau >= kLeastHeldTau;
    return near ? DeviationMeasure::kAlongSurface : deviation;
  }
  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

}  // namespace talweg

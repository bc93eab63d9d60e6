// The smoothing options are the parameters of a drawing and of its smoothing, with units, ranges
// and defaults.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/core/lifting/potential.hpp"
#include "talweg/core/measure/deviation_measure.hpp"
#include "talweg/intrinsic/budget.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The potential that keeps a curve near its drawing, and the distance in it.
enum class Method {
  kPaper,     ///< equations 4 to 6 over the heat method's distance on the whole mesh
  kCorridor,  ///< flat within the slack, exact distance in a band, phase for loops
};

/// The options that apply when a curve is set.
struct CurveOptions {
  Method method = Method::kCorridor;  ///< potential and distance
  double heat_time = 10;              ///< of the heat method, in units of h²; [1e-3, 1e6]
  /// Whether the paper's distance, the main cost of setting a curve, is computed when the curve is
  /// set. Otherwise it is computed on first use; tau = 0 does not use it.
  bool distance_at_once = true;
  /// Mesh units, > 0: if given, the distance is also smoothed by equation 3 within this radius.
  std::optional<double> bump_radius;
  bool cap_corners = true;  ///< as the paper does; affects only curves along mesh edges
  unsigned threads = 2;  ///< at most, for factorising the heat matrices; >= 1; no effect on results
  std::vector<SurfacePoint> pins;  ///< points of the drawing that the result must pass through
  /// Points of the drawing that the result must pass through, where a fair curve may have a kink.
  /// At other pins and way-points it has none.
  std::vector<SurfacePoint> corners;
  /// Whether two fair curves continue each other without a kink where exactly their two ends meet
  /// and no other curve passes. False is for a set that is only a part of all curves.
  bool join_ends = true;
  /// For the corridor: clicked points that the result must pass. The drawing between two
  /// consecutive way-points of a curve (a leg) is not a stroke: it defines only the side on which
  /// the curve passes holes and handles. There the result is a spline with the tension tau.
  std::vector<WayPoint> way_points;
  /// Mesh units, >= 0: consecutive way-points of a curve within this distance are merged. The
  /// default is about one edge of the mesh there, and at most a quarter of the median distance
  /// between consecutive way-points.
  std::optional<double> click_distance;
  /// Painted points of the drawing. Between the two way-points around a painted point, the drawing
  /// is a stroke. Curves without way-points are strokes, and so are ends before the first and after
  /// the last way-point.
  std::vector<SurfacePoint> painted;

  [[nodiscard]] HeatSettings heat() const { return {heat_time, threads, bump_radius}; }
  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// The finish of the corridor's curves.
enum class Finish {
  kTaut,  ///< straightened curves of FlipOut
  kFair,  ///< curves that bend as little as possible within the corridor
};

/// The least tau that keeps a result near its drawing; with a smaller tau a result may be anywhere.
constexpr double kLeastHeldTau = 1.0 / 8;

/// Options of one curve of a set. Values that are not given are those for all curves.
struct OwnOptions {
  std::optional<double> tau;    ///< [0, infinity)
  std::optional<double> slack;  ///< mesh units, >= 0
  std::optional<Finish> finish;

  bool operator==(const OwnOptions&) const = default;
};

/// The options that may change from one smooth() to the next.
struct SmoothingOptions {
  double tau = 1;  ///< [0, infinity): 0 gives geodesics, larger values stay closer to the drawing
  PotentialOptions potential;   ///< for the paper's method
  std::optional<double> slack;  ///< for the corridor, mesh units, >= 0; see CurveSmoother::slack()
  /// Unless empty, replaces `slack`: per drawn curve one value per point, mesh units, >= 0, linear
  /// between points. See slack_along().
  std::vector<std::vector<double>> slack_at;
  /// For the corridor: unless empty, one entry per drawn curve. Curves of different tau do not
  /// cross. A curve that others do not touch is the same as if its tau were used for all curves.
  std::vector<OwnOptions> per_curve;
  int phase_turns =
      3;  ///< turns of the corridor's phase around a loop, at most points / 8; [0, 64]
  Finish finish = Finish::kFair;  ///< for the corridor; curves of tau = 0 are taut
  int relax_rounds = 0;           ///< rounds of the paper's relaxation; the paper uses 5
  std::optional<std::size_t> max_iterations;  ///< of FlipOut; default: FlipOut's own bound
  double min_relative_length = 0;  ///< FlipOut stops at this fraction of the lifted length; [0, 1)
  /// Mesh units, >= 0: a shorter loop counts as collapsed. Default: 3 mean segments of the drawn
  /// loop, at most half of its length.
  std::optional<double> length_floor;
  /// The measure of the deviation between result and drawing in the report.
  DeviationMeasure deviation = DeviationMeasure::kAutomatic;
  bool prepare_whole_mesh =
      false;  ///< compute all lengths and signposts first; slower, same result
  /// The budget of one call of smooth(), drag() or smooth_within(). When it is used up, fairing,
  /// the search and measuring end; the result is the best one found, with the termination kLimit
  /// and warnings about incomplete steps.
  Budget budget;

  /// The value for one curve; `curve` is an index into `per_curve`.
  [[nodiscard]] double tau_of(std::size_t curve) const;
  [[nodiscard]] std::optional<double> slack_of(std::size_t curve) const;
  [[nodiscard]] Finish finish_of(std::size_t curve) const;
  /// The options for smoothing one curve alone, with its tau, slack and finish; without slack_at
  /// and per_curve.
  [[nodiscard]] SmoothingOptions of(std::size_t curve) const;
  /// The measure for one curve: kAutomatic is kAlongSurface if the curve's tau is at least
  /// kLeastHeldTau.
  [[nodiscard]] DeviationMeasure deviation_measure(std::size_t curve) const;
  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

}  // namespace talweg

// The options of a drawing and of its smoothing have units, ranges and defaults.
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

/// Which potential holds the curve, and which distance it is a function of.
enum class Method {
  kPaper,     ///< equations 4 to 6 over the heat method's distance on the whole mesh
  kCorridor,  ///< flat within the slack, exact distance in a band, phase for loops
};

/// The options that apply when a curve is set.
struct CurveOptions {
  Method method = Method::kCorridor;  ///< also decides which distance is measured
  double heat_time = 10;              ///< of the distance's heat flow, in units of h²; [1e-3, 1e6]
  /// Whether the paper's distance, which dominates the cost of setting a curve, is computed when
  /// the curve is set. Otherwise it is computed when first needed; at tau = 0 it is never needed.
  bool distance_at_once = true;
  /// Mesh units, > 0: the distance is also smoothed by equation 3, within this radius.
  std::optional<double> bump_radius;
  bool cap_corners = true;  ///< as the paper does; affects only curves along mesh edges
  unsigned threads = 2;  ///< at most, for factorising the heat matrices; >= 1; no effect on results
  std::vector<SurfacePoint> pins;  ///< points of the drawing that the result must pass through
  /// The same, where a fair curve may also turn as sharply as it likes. At pins and way-points that
  /// are not among these it passes without a kink.
  std::vector<SurfacePoint> corners;
  /// Whether fair curves continue each other without a kink where exactly two ends of the set meet
  /// and nothing else of it passes. False is for a set that is only a part of all curves.
  bool join_ends = true;
  /// For the corridor. Between two of these that follow each other on a curve, the drawing is no
  /// stroke: it tells only on which side of holes and handles the curve passes. The result is a
  /// spline there, and tau its tension.
  std::vector<WayPoint> way_points;
  /// Way-points that follow each other on a curve at no more than this distance (mesh units, >= 0)
  /// are one: nobody can have meant more than one. By default an edge of the mesh there, and at
  /// most a quarter of the median distance between them.
  std::optional<double> click_distance;
  /// Points of the drawing that were painted. Between the two way-points around one of these, the
  /// drawing is a stroke, as are curves without way-points and the ends before and after these.
  std::vector<SurfacePoint> painted;

  [[nodiscard]] HeatSettings heat() const { return {heat_time, threads, bump_radius}; }
  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

/// What becomes of the corridor's straightened curves.
enum class Finish {
  kTaut,  ///< they stay as FlipOut leaves them
  kFair,  ///< they bend as little as they can within the corridor
};

/// From this tau on a result keeps near its drawing; below it may lead anywhere.
constexpr double kLeastHeldTau = 1.0 / 8;

/// What may differ from curve to curve of a set. What is not given is as for all.
struct OwnOptions {
  std::optional<double> tau;    ///< [0, infinity)
  std::optional<double> slack;  ///< mesh units, >= 0
  std::optional<Finish> finish;

  bool operator==(const OwnOptions&) const = default;
};

/// The options that may change from one smooth() to the next.
struct SmoothingOptions {
  double tau = 1;  ///< [0, infinity): 0 gives geodesics, more keeps closer to the drawing
  PotentialOptions potential;   ///< for the paper's method
  std::optional<double> slack;  ///< for the corridor, mesh units, >= 0; see CurveSmoother::slack()
  /// Unless empty, it replaces `slack`: per drawn curve one value per point, mesh units, >= 0,
  /// linear in between. See slack_along().
  std::vector<std::vector<double>> slack_at;
  /// For the corridor: unless empty, one for each drawn curve. Curves of different tau do not cross
  /// either, and each is what it would be if its tau were that of all, as far as the others do not
  /// touch it.
  std::vector<OwnOptions> per_curve;
  int phase_turns = 3;  ///< of the corridor's phase around a loop, at most points / 8; [0, 64]
  Finish finish = Finish::kFair;  ///< of the corridor's curves; those of tau = 0 are taut
  int relax_rounds = 0;           ///< rounds of the paper's relaxation; its authors use 5
  std::optional<std::size_t> max_iterations;  ///< of FlipOut; by default its own bound
  double min_relative_length = 0;  ///< stop at this fraction of the lifted length; [0, 1)
  /// A loop shorter than this counts as collapsed. Mesh units; by default 3 mean edges of the drawn
  /// loop, at most half of its length.
  std::optional<double> length_floor;
  /// How the deviation between result and drawing is measured for the report.
  DeviationMeasure deviation = DeviationMeasure::kAutomatic;
  bool prepare_whole_mesh = false;  ///< lay out everything first; slower, same result
  /// What one call of smooth(), drag() or smooth_within() may use up. When it is used up, fairing,
  /// the search and the deviation end; the result is the best so far, its `termination` is
  /// kLimit, and its report says what holds.
  Budget budget;

  /// For one of the curves, in the order in which `per_curve` is.
  [[nodiscard]] double tau_of(std::size_t curve) const;
  [[nodiscard]] std::optional<double> slack_of(std::size_t curve) const;
  [[nodiscard]] Finish finish_of(std::size_t curve) const;
  /// The options of one of the curves as those of all; without slack_at.
  [[nodiscard]] SmoothingOptions of(std::size_t curve) const;
  /// What `deviation` means for the tau of one of the curves.
  [[nodiscard]] DeviationMeasure deviation_measure(std::size_t curve) const;
  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

}  // namespace talweg

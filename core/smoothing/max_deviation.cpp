#include "talweg/core/smoothing/max_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/drawing/canonical_order.hpp"
#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kMostTau = 64;
constexpr double kFairTau = 1;          // where the ladder begins: needs no further rung
constexpr double kSureSlack = 2 / 3.0;  // times the bound: the walls of this slack are at the bound
constexpr int kSlackHalvings = 6;
/// Narrowing ends after kLostRounds rounds that did not reduce the deviation by the factor
/// kLostPart.
constexpr int kLostRounds = 4;
constexpr double kLostPart = 0.98;
constexpr double kFineness = 1.05;  // factor in tau and slack at which a search ends
constexpr int kPinRounds = 8;
/// The narrowing of the slack near a corner that the result cuts off: its reach along the drawing,
/// and its factor per round.
struct Narrowing {
  double reach;  // times the bound D
  double factor;
  int rounds;
};
constexpr Narrowing kGently = {1, 0.85, 20}, kFirmly = {2, 0.6, 12};

double to_drawn(const SmoothingResult& result) { return result.total.deviation_to_drawn_max; }
/// The total curvature of all curves. Sorting makes the sum independent of the curves' order.
double curvature(const SmoothingResult& result) {
  std::vector<double> each;
  each.reserve(result.reports.size());
  for (const SmoothingReport& report : result.reports) each.push_back(report.after.total_curvature);
  std::sort(each.begin(), each.end());
  return std::accumulate(each.begin(), each.end(), 0.0);
}
double both_ways(const SmoothingResult& result) {
  return std::max(to_drawn(result), result.total.deviation_from_drawn_max);
}

class BoundSearch {
 public:
  BoundSearch(CurveSmoother& smoother, double bound, SmoothingOptions options, Progress progress)
      : smoother_(smoother),
        bound_(bound),
        options_(std::move(options)),
        progress_(options_.budget.any() ? progress.with(options_.budget) : std::move(progress)),
        own_pins_(smoother.pins().begin(), smoother.pins().end()) {
    options_.budget = {};  // one budget for the whole search
    const auto has_slack = [](const OwnOptions& own) { return own.slack.has_value(); };
    given_slack_ = options_.slack || !options_.slack_at.empty() ||
                   std::any_of(options_.per_curve.begin(), options_.per_curve.end(), has_slack);
    for (OwnOptions& own : options_.per_curve) own.tau.reset();
    for (const SurfaceCurve& drawn : smoother_.drawn()) {
      orders_.push_back(canonical_order(smoother_.opened().mesh(), drawn));
      ordered_.push_back(in_order(drawn, orders_.back()));
      const CurveOptions& own = smoother_.curve_options();
      on_stroke_.push_back(on_strokes(
          legs_of(ordered_.back(), own.pins, own.way_points, own.painted), ordered_.back()));
    }
  }
  /// Runs the search, and restores the smoother's pins, also after an exception.
  SmoothingResult run() {
    try {
      SmoothingResult result = search();
      smoother_.set_pins(own_pins_);
      return result;
    } catch (...) {
      smoother_.set_pins(own_pins_);
      throw;
    }
  }

 private:
  SmoothingResult search() {
    const auto closed = [](const SurfaceCurve& curve) { return curve.closed; };
    // A geodesic within the bound is the smoothest curve. Loops would collapse at tau = 0.
    if (std::none_of(ordered_.begin(), ordered_.end(), closed) &&
        measured(0, both_ways) <= bound_) {
      finish();
      return std::move(best_);
    }
    if (given_slack_) {
      try_taus();
    } else {
      try_slacks();
    }
    if (ended_ && !cancelled_) hold_near();
    if (cancelled_ || best_.curves.empty()) return std::move(last_);
    finish();
    return std::move(best_);
  }

  using Measure = double (*)(const SmoothingResult&);

  /// The search with a given slack: by tau alone; then with pinned corners, if they may allow a
  /// smaller tau.
  void try_taus() {
    begin_with(options_.slack);
    const double loose = least_tau(to_drawn);
    const double tight = least_tau(both_ways);
    if (is_over()) return;
    if (tight > loose * kFineness * kFineness || both_ways(best_) > bound_) pin_corners(loose);
  }

  /// The search by slack: wider walls give smoother curves. If the widest walls let corners be cut
  /// off, the corners are pinned, or the walls are narrowed near them or everywhere.
  void try_slacks() {
    const double loose = widest_slack(kSureSlack * bound_, bound_, to_drawn);
    if (is_over()) return;
    begin_with(loose);
    if (measured(kFairTau, both_ways) <= bound_) return;
    narrow_everywhere(loose);
    if (is_over()) return;
    begin_with(loose);
    pin_corners(kFairTau);
    for (const Narrowing& way : {kGently, kFirmly}) narrow_at_corners(loose, way);
  }

  void narrow_everywhere(double slack) {
    double low = slack, high = slack;
    for (int halving = 0; halving < kSlackHalvings && !is_over(); ++halving) {
      high = low;
      low /= 2;
      begin_with(low);
      if (measured(kFairTau, both_ways) > bound_) continue;
      widest_slack(low, high, both_ways);
      return;
    }
  }

  void begin_with(std::optional<double> slack) {
    options_.slack = slack;
    if (!smoother_.set_pins(own_pins_, progress_)) throw Cancelled();
    pinned_ = 0;
  }

  /// Narrows the slack only near corners that the result cuts off. Unlike a pin, narrowing makes no
  /// kink.
  void narrow_at_corners(double slack, const Narrowing& way) {
    begin_with(slack);
    for (const SurfaceCurve& drawn : ordered_) {
      options_.slack_at.emplace_back(drawn.points.size(), slack);
    }
    double least = HUGE_VAL;
    for (int round = 0, lost = 0; round < way.rounds && lost < kLostRounds && !is_over(); ++round) {
      const double apart = measured(kFairTau, both_ways);
      if (apart <= bound_) break;
      lost = apart < kLostPart * least ? 0 : lost + 1;
      least = std::min(least, apart);
      for (std::size_t c = 0; c < ordered_.size(); ++c) narrow(c, way);
    }
    options_.slack_at.clear();
  }

  /// Narrows the slack of curve c at points farther than the bound from the last result, and at
  /// points within `way.reach` bounds of them along the drawing.
  void narrow(std::size_t c, const Narrowing& way) {
    const SurfaceCurve& drawn = ordered_[c];
    const std::size_t n = drawn.points.size(), around = drawn.closed ? n : 0;
    const std::vector<double> far = distances_to_result(c);
    std::vector<double> along{0};  // arc length at each point; of two rounds of a loop
    for (std::size_t k = 1; k < n + around; ++k) {
      const SurfaceCurve leg{false, {drawn.points[(k - 1) % n], drawn.points[k % n]}};
      along.push_back(along.back() + curve_length(smoother_.opened().surface(), leg));
    }
    const double reach = way.reach * bound_;
    std::vector<bool> near(n, false);
    for (std::size_t k = 0; k < n; ++k) {
      if (far[k] <= bound_) continue;
      const std::size_t back = k + around;
      for (std::size_t j = k; j < k + n && j < along.size() && along[j] - along[k] <= reach; ++j) {
        near[j % n] = true;
      }
      for (std::size_t j = back; j-- > 0 && along[back] - along[j] <= reach;) near[j % n] = true;
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (near[k]) options_.slack_at[c][orders_[c].drawn_index(k, n)] *= way.factor;
    }
  }

  /// The distances of the points of curve c, in canonical order, to the last result; 0 for points
  /// on legs, which have no bound. Throws Cancelled.
  std::vector<double> distances_to_result(std::size_t c) {
    if (!to_result_) to_result_.emplace(smoother_.opened().surface());
    SurfaceCurve result = last_.curves[c];
    if (orders_[c].reversed) std::reverse(result.points.begin(), result.points.end());
    ProgressPoller poller(progress_, "measure");
    const ScopedPoller scoped(*to_result_, poller);
    to_result_->set(std::span(&result, 1));
    std::vector<double> distances;
    for (std::size_t i = 0; i < ordered_[c].points.size(); ++i) {
      distances.push_back(on_stroke_[c][i] ? to_result_->at(ordered_[c].points[i]).distance : 0);
    }
    return distances;
  }

  /// The widest slack between `low` and `high` with a result within the bound, by bisection;
  /// assumes that the deviation grows with the slack and that `low` is within the bound.
  double widest_slack(double low, double high, Measure measure) {
    while (high > low * kFineness && !is_over()) {
      const double middle = std::sqrt(low) * std::sqrt(high);
      begin_with(middle);
      (measured(kFairTau, measure) <= bound_ ? low : high) = middle;
    }
    return low;
  }

  /// Whether the search ends: cancelled, or the budget is used up after at least one result.
  bool is_over() {
    ended_ = ended_ || (!best_.curves.empty() && ends_early(progress_));
    return cancelled_ || ended_;
  }

  /// One more try if the budget ended the search without a curve within the bound: walls at half
  /// the bound.
  void hold_near() {
    if (both_ways(best_) <= bound_) return;
    if (!given_slack_) begin_with(kSureSlack / 2 * bound_);
    measured_now(kFairTau, both_ways);
  }

  double measured(double tau, Measure measure) {
    if (is_over()) return HUGE_VAL;
    return measured_now(tau, measure);
  }
  double measured_now(double tau, Measure measure) {
    options_.tau = tau;
    // Upper bounds suffice, but distances through space prove nothing.
    const bool held = tau >= kLeastHeldTau;
    options_.deviation = held ? DeviationMeasure::kAutomatic : DeviationMeasure::kAlongSurface;
    last_ = smoother_.smooth(options_, progress_);
    cancelled_ = last_.total.termination == Outcome::kCancelled;
    if (!cancelled_) keep_better();
    return measure(last_);
  }

  /// The smallest tau with a result within the bound, assuming that the deviation decreases with
  /// tau; the largest tried tau if there is none.
  double least_tau(Measure measure) {
    double low = 1, high = 1;
    if (measured(1, measure) <= bound_) {
      do {
        high = low;
        low /= 4;
      } while (low >= kLeastHeldTau && measured(low, measure) <= bound_);
      if (low < kLeastHeldTau) return high;
    } else {
      do {
        low = high;
        high *= 4;
      } while (high <= kMostTau && measured(high, measure) > bound_);
      if (high > kMostTau) return low;
    }
    while (high > low * kFineness && !is_over()) {
      const double middle = std::sqrt(low) * std::sqrt(high);
      (measured(middle, measure) <= bound_ ? high : low) = middle;
    }
    return high;
  }

  void pin_corners(double tau) {
    std::vector<SurfacePoint> pins = own_pins_;
    if (measured(tau, both_ways) <= bound_) return;
    for (int round = 0; round < kPinRounds && !is_over(); ++round) {
      const std::size_t before = pins.size();
      add_lost_corners(pins);
      if (pins.size() == before || to_drawn(last_) > bound_) tau *= 1.25;
      if (!smoother_.set_pins(pins, progress_)) throw Cancelled();
      pinned_ = pins.size() - own_pins_.size();
      if (measured(tau, both_ways) <= bound_) return;
    }
  }

  /// Adds the farthest point of each stretch of the drawing that is beyond the bound from the last
  /// result.
  void add_lost_corners(std::vector<SurfacePoint>& pins) {
    for (std::size_t c = 0; c < ordered_.size(); ++c) {
      const SurfaceCurve& drawn = ordered_[c];
      const std::vector<double> far = distances_to_result(c);
      const std::size_t n = far.size();
      // On a loop, the search starts at a point within the bound.
      std::size_t first = 0;
      while (drawn.closed && first < n && far[first] > bound_) ++first;
      const SurfacePoint* farthest = nullptr;
      double most = 0;
      const auto add = [&] {
        if (farthest != nullptr && std::find(pins.begin(), pins.end(), *farthest) == pins.end()) {
          pins.push_back(*farthest);
        }
        farthest = nullptr;
        most = 0;
      };
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = (first + i) % n;
        if (far[k] <= bound_) {
          add();
        } else if (far[k] > most) {
          most = far[k];
          farthest = &drawn.points[k];
        }
      }
      add();
    }
  }

  /// Keeps the last result if it is better: the smoothest within the bound or, without one, the
  /// nearest.
  void keep_better() {
    const auto worse = [this](const SmoothingResult& a, const SmoothingResult& b) {
      const double over_a = std::max(both_ways(a), bound_), over_b = std::max(both_ways(b), bound_);
      const auto is_proper = [this](const SmoothingResult& result) {
        const Outcome outcome = result.total.termination;
        return outcome == Outcome::kConverged ||
               (outcome == Outcome::kLimit && has_ended_early(progress_));
      };
      const bool proper_a = is_proper(a), proper_b = is_proper(b);
      if (proper_a != proper_b) return proper_b;
      return over_a != over_b ? over_a > over_b : curvature(a) > curvature(b);
    };
    if (!best_.curves.empty() && !worse(best_, last_)) return;
    best_ = last_;
    best_pinned_ = pinned_;
  }

  void finish() {
    const auto fill = [&](SmoothingReport& report) {
      report.max_deviation = bound_;
      report.pins_added = best_pinned_;
      const double apart = std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max);
      if (!(apart <= bound_)) {
        const bool limited = report.termination == Outcome::kLimit && has_ended_early(progress_);
        if (!limited) report.termination = Outcome::kDeviation;
        std::string sentence = fmt::format(
            "No curve within {:.6g} of the drawing was found; the result deviates by {}{:.6g}.",
            bound_, report.deviation_exact ? "" : "at most ", apart);
        warn_decisively(report, {std::move(sentence), report.deviation_at});
      }
      if (!ended_) return;
      report.termination = std::max(report.termination, Outcome::kLimit);
      report.warnings.emplace_back(
          "The budget was used up during the search: there may be a smoother curve within the "
          "bound.");
    };
    for (SmoothingReport& report : best_.reports) fill(report);
    fill(best_.total);
    const std::vector<double> slacks = smoother_.slack();
    for (std::size_t c = 0; c < slacks.size(); ++c) {
      warn_if_too_narrow(slacks[c], best_.reports[c]);
      if (slacks.size() == 1) best_.total.warnings = best_.reports[c].warnings;
    }
  }

  /// Warns if the bound is below the trembling of the hand, so that hardly anything can be
  /// smoothed.
  void warn_if_too_narrow(double slack, SmoothingReport& report) const {
    constexpr double kHardly = 0.5,
                     kTrembles = 1;  // fraction of the bending before; least bending before
    if (given_slack_ || !(bound_ < slack) || report.before.bending < kTrembles) return;
    if (report.after.bending <= kHardly * report.before.bending) return;
    report.warnings.push_back(
        fmt::format("The bound of {:.4g} is smaller than the trembling of the drawing ({:.4g}), so "
                    "the result is hardly smoother than the drawing.",
                    bound_, slack));
  }

  CurveSmoother& smoother_;
  double bound_;
  SmoothingOptions options_;
  Progress progress_;
  std::vector<SurfacePoint> own_pins_;
  // The drawing in canonical order.
  std::vector<CurveOrder> orders_;
  std::vector<SurfaceCurve> ordered_;
  std::vector<std::vector<bool>> on_stroke_;  // per point of ordered_
  std::optional<PolylineDistance> to_result_;
  SmoothingResult last_, best_;
  std::size_t pinned_ = 0, best_pinned_ = 0;
  bool given_slack_ = false;
  bool cancelled_ = false;
  bool ended_ = false;  // the budget ended the search
};

}  // namespace

SmoothingResult smooth_within(CurveSmoother& smoother, double max_deviation,
                              const SmoothingOptions& options, const Progress& progress) {
  if (!(max_deviation > 0 && std::isfinite(max_deviation))) {
    throw Error(ErrorCode::kBadUsage, "max_deviation must be finite and > 0.");
  }
  if (smoother.drawn().empty()) throw Error(ErrorCode::kBadUsage, "No curve is set.");
  if (smoother.slack().empty()) {  // restoring the pins then cannot fail
    throw Error(ErrorCode::kBadUsage, "smooth_within() needs the corridor.");
  }
  try {
    return BoundSearch(smoother, max_deviation, options, progress).run();
  } catch (const Cancelled&) {  // between two runs
    return smoother.smooth(options, [](const char*, double) { return false; });
  }
}

}  // namespace talweg

#include "talweg/core/smoothing/fair_finishing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/fairing/fair_measures.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr double kNoTurn = 1e-6;               // rad
constexpr double kBands[] = {1, 1, 0.7, 0.4};  // fraction of the walls' distance, per try
constexpr std::size_t kFromTaut = 1;           // the try that starts from the taut curve
constexpr std::size_t kTries = std::size(kBands), kBent = kTries + 1, kGivenUp = kTries + 2;
constexpr double kNoBending = 1e-4;

/// The exponent c of LegTension for the legs of a spline. With c < 1, the spline would swing out
/// widely at sharp turns between its legs.
double tension_of(double tau) { return std::clamp(20 * tau, 1.0, 160.0); }
constexpr double kTighter = 8;  // factor in a spline's tension per try
constexpr const char* kTooLong =
    "A fair curve of this length needs more than 100,000 samples for its slack; fewer are used, so "
    "the result may bend more.";
constexpr const char* kLeftTaut =
    "No fair curve was found within the slack of the drawing; the result is taut, with kinks.";
constexpr const char* kEndedTaut =
    "The budget was used up before the curve was fair; the result is taut, with kinks.";
constexpr const char* kEndedFair =
    "The budget was used up while the curve was made fair; the result may bend more than "
    "necessary.";

/// The two stretches of a curve that meet at fixed point number `point`; empty if there are not
/// two.
SurfaceCurve about_fixed(const std::vector<SurfacePoint>& fixed, std::size_t point,
                         const SurfaceCurve& curve) {
  const std::vector<std::size_t> stretches = stretches_along(fixed, curve);
  const std::size_t n = curve.points.size(), m = fixed.size();
  SurfaceCurve part;
  if (stretches.empty() || m < 3 || (!curve.closed && (point == 0 || point + 1 == m))) return part;
  const std::size_t before = (point + m - 1) % m;
  std::size_t first = 0;
  while (!(curve.points[first] == fixed[before] && stretches[first] == before)) {
    if (++first == n) return part;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (first + i) % n;
    if (stretches[k] != before && stretches[k] != point) break;
    part.points.push_back(curve.points[k]);
    if (!curve.closed && k + 1 == n) break;
  }
  return part;
}

}  // namespace

void FairFinishing::run(const std::vector<FairGroup>& groups, const FairChains& chains,
                        std::vector<CurveResult>& curves) {
  curves_ = &curves;
  now_.resize(curves.size());
  attempt_of_.resize(curves.size());
  for (std::size_t g = 0; g < groups.size(); ++g) begin(groups[g], chains[g]);
  // Groups are faired separately, so curves near each other, or strands of one curve, may cross.
  for (bool again = !curves.empty(); again;) {
    again = false;
    std::vector<bool> done(attempts_.size(), false);
    for (const std::size_t c : crossing_curves(solver_->drawing().surface(), now_)) {
      const std::size_t a = attempt_of_[c];
      if (a >= done.size() || done[a] || crosses_as_drawn(c)) continue;
      if (attempts_[a].tries == 0 || attempts_[a].tries == kGivenUp) continue;
      done[a] = true;
      if (has_legs(solver_->drawing(), attempts_[a].group)) {
        tighten(attempts_[a], crossed_points(c, now_[c]), now_[c]);
      }
      make_fair(a);
      again = true;
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    curves[c].curve = std::move(now_[c]);
    const Attempt& attempt = attempts_[attempt_of_[c]];
    if (attempt.left_taut == kEndedFair) {
      curves[c].warnings.push_back(attempt.left_taut);
    } else {
      curves[c].left_taut = attempt.left_taut;
    }
    if (attempt.tries == 0 || !has_ended_early(*progress_)) continue;
    curves[c].ended_early = true;
    if (attempt.tries != kGivenUp) curves[c].warnings.emplace_back(kEndedFair);
  }
}

/// Whether a curve that is allowed to cross has at most as many crossed points as the taut curve,
/// or at most 1.1 times the crossings of the drawing; a crossing counts as two points.
bool FairFinishing::crosses_as_drawn(std::size_t curve) {
  if (!solver_->drawing().may_cross()) return false;
  if (!taut_by_face_) taut_by_face_.emplace(solver_->drawing().surface(), taut_().curves);
  const std::size_t now = crossed_points(curve, now_[curve]).size();
  return now <= taut_by_face_->crossed_points(curve, taut_().curves[curve]).size() ||
         now <= 2 * solver_->drawing().crossings() + solver_->drawing().crossings() / 5;
}

void FairFinishing::begin(const FairGroup& group, const std::optional<SampleChain>& chain) {
  const std::size_t a = attempts_.size();
  for (const JoinedCurves::Part& part : group.joined.parts) attempt_of_[part.curve] = a;
  attempts_.push_back({group, chain});
  const std::size_t c = group.joined.parts.front().curve;
  if (!CorridorSolver::is_faired(*options_, c)) {
    set(c, taut_().curves[c]);
    return;
  }
  const bool any_legs = has_legs(solver_->drawing(), group);
  if (solver_->is_narrow(c) && !any_legs) {
    set(c, solver_->in_narrow_band(options_->tau_of(c), c, taut_().curves[c], poller_));
    return;
  }
  if (any_legs &&
      !total_turn_reaches(kNoTurn, solver_->drawing().surface(), taut(attempts_[a]).curve,
                          solver_->drawing().corners())) {  // straight legs are fair
    for (const JoinedCurves::Part& part : group.joined.parts) {
      set(part.curve, taut_().curves[part.curve]);
    }
    return;
  }
  warn_if_too_long(group);
  make_fair(a);
}

const FairFinishing::Taut& FairFinishing::taut(Attempt& attempt) {
  if (attempt.taut) return *attempt.taut;
  Taut own{joined(attempt.group.joined, taut_().curves), false};
  own.is_close = is_close(attempt.group, taus_of(attempt.group, *options_), own.curve);
  return attempt.taut.emplace(std::move(own));
}

void FairFinishing::warn_if_too_long(const FairGroup& group) {
  if (has_legs(solver_->drawing(), group)) return;
  const double length = curve_length(solver_->drawing().surface(), group.drawn);
  bool too_long = false;
  solver_->with_fairing(group, taus_of(group, *options_), 1, {}, poller_,
                        [&](const CurveFairing& f) { too_long = f.is_too_long(length); });
  if (too_long) (*curves_)[group.joined.parts.front().curve].warnings.emplace_back(kTooLong);
}

/// Whether a taut curve lies between the walls, and no part of the drawing is far from it. For tau
/// < kLeastHeldTau parts of the drawing may be far.
bool FairFinishing::is_close(const FairGroup& group, const Taus& taus, const SurfaceCurve& taut) {
  constexpr double kFar = 4;  // walls
  if (has_legs(solver_->drawing(), group)) return true;
  if (!keeps_within(group, taus, taut)) return false;
  if (*std::min_element(taus.begin(), taus.end()) < kLeastHeldTau) return true;
  if (solver_->drawing().erases_loops()) return true;  // the short remainder is intended
  const SurfaceMesh& mesh = solver_->drawing().mesh();
  const NearestSegment nearest(segments_of(positions_of(mesh, taut), taut.closed));
  const double far = kFar * solver_->largest_wall(group, taus);
  const std::vector<Point> drawn = positions_of(mesh, group.drawn);
  return std::none_of(drawn.begin(), drawn.end(),
                      [&](const Point& p) { return nearest.to(p).distance > far; });
}

void FairFinishing::make_fair(std::size_t number) {
  std::optional<SurfaceCurve> fair;
  Attempt& attempt = attempts_[number];
  const Taus taus = taus_of(attempt.group, *options_);
  // A new try needs more than the remainder of a budget that is used up.
  bool ended = false;
  while (!fair && attempt.tries < kTries && !ended) {
    fair = tried(attempt, taus);
    ++attempt.tries;
    ended = !fair && poller_.ends_early();
  }
  if (!fair && attempt.tries < kBent) {
    fair = std::move(attempt.bent);
    attempt.tries = kBent;
  }
  const FairGroup group = attempt.group;  // a copy: attempts_ may grow
  const auto curves =
      split_at_junctions(group.joined, group.junctions, fair ? *fair : taut(attempt).curve);
  for (std::size_t k = 0; k < curves.size(); ++k) set(group.joined.parts[k].curve, curves[k]);
  if (fair) return;
  attempt.tries = kGivenUp;
  if (group.joined.is_joined() && !ended) {
    make_fair_apart(group);
  } else {
    const bool smooth = is_smooth(attempt, taus);
    if (ended || has_ended_early(*progress_)) {
      attempt.left_taut = smooth ? kEndedFair : kEndedTaut;
    } else if (!smooth) {
      attempt.left_taut = kLeftTaut;
    }
  }
}

/// The points where `curve`, as curve `number`, would cross itself or the other current curves.
std::vector<SurfacePoint> FairFinishing::crossed_points(std::size_t number,
                                                        const SurfaceCurve& curve) {
  if (!by_face_) by_face_.emplace(solver_->drawing().surface(), now_);
  return by_face_->crossed_points(number, curve);
}

void FairFinishing::set(std::size_t number, SurfaceCurve curve) {
  if (by_face_) by_face_->replace(number, curve);
  now_[number] = std::move(curve);
}

/// Whether a curve bends more than the taut curve, if the taut curve is close to the drawing;
/// otherwise whether it bends more than the drawing.
bool FairFinishing::bends_more(Attempt& attempt, const SurfaceCurve& curve) {
  const EmbeddedDrawing& drawing = solver_->drawing();
  const FairGroup& group = attempt.group;
  const auto bending = [&](const SurfaceCurve& c) {
    return bending_between(drawing.surface(), c, drawing.corners(), group.edge);
  };
  const double own = bending(curve);
  if (own <= kNoBending) return false;
  return own > bending(taut(attempt).is_close ? taut(attempt).curve : group.drawn);
}

/// The fixed points about which a curve bends more than the taut curve.
std::vector<SurfacePoint> FairFinishing::bends_more_at(Attempt& attempt,
                                                       const SurfaceCurve& curve) {
  const EmbeddedDrawing& drawing = solver_->drawing();
  const FairGroup& group = attempt.group;
  const SurfaceCurve& taut = this->taut(attempt).curve;
  const auto legs = leg_start(drawing, group, taut, 1);
  std::vector<SurfacePoint> bad;
  if (!legs) return bad;
  std::vector<SurfacePoint> fixed;
  for (const std::size_t i : legs->fixed) fixed.push_back(taut.points[i]);
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    const SurfaceCurve own = about_fixed(fixed, k, curve), before = about_fixed(fixed, k, taut);
    if (own.points.size() < 3 || before.points.size() < 3) continue;
    const auto bending = [&](const SurfaceCurve& c) {
      return bending_between(drawing.surface(), c, drawing.corners(), group.edge);
    };
    if (bending(own) > bending(before)) bad.push_back(fixed[k]);
  }
  return bad;
}

/// Increases the tension of the stretches of a curve that contain the points `at`; of all stretches
/// if there are no points or the stretches are not found.
void FairFinishing::tighten(Attempt& attempt, std::span<const SurfacePoint> at,
                            const SurfaceCurve& curve) {
  const SurfaceCurve& taut = this->taut(attempt).curve;
  const auto legs = leg_start(solver_->drawing(), attempt.group, taut, 1);
  if (!legs) return;
  const std::size_t n = legs->tension.is_leg.size();
  attempt.tighter.resize(n, 1);
  std::vector<SurfacePoint> fixed;
  for (const std::size_t i : legs->fixed) fixed.push_back(taut.points[i]);
  const std::vector<std::size_t> stretches = stretches_along(fixed, curve);
  std::vector<bool> bad(n, at.empty() || stretches.empty());
  const PointLookup places(at);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (!places.contains(curve.points[i])) continue;
    const std::size_t k = stretches[i];
    bad[k] = true;
    const bool begins = i == 0 ? curve.closed : stretches[i - 1] != k;
    if (begins && (curve.closed || k > 0)) bad[(k + n - 1) % n] = true;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (bad[k]) attempt.tighter[k] *= kTighter;
  }
}

void FairFinishing::make_fair_apart(const FairGroup& group) {
  for (const JoinedCurves::Part& part : group.joined.parts) {
    const FairGroup one = fair_group(solver_->drawing(), {{{part.curve, false}}});
    begin(one, solver_->fair_from(one, taus_of(one, *options_), taut_, *progress_));
  }
}

/// Whether the taut curve does not turn and is close to the drawing; it is then fair.
bool FairFinishing::is_straight(Attempt& attempt) {
  const Taut& own = taut(attempt);
  return own.is_close && !total_turn_reaches(kNoTurn, solver_->drawing().surface(), own.curve,
                                             solver_->drawing().corners());
}

/// Whether the taut curve turns as little as a fair curve and lies between the walls; false for
/// groups with legs.
bool FairFinishing::is_smooth(Attempt& attempt, const Taus& taus) {
  if (has_legs(solver_->drawing(), attempt.group)) return false;
  const std::vector<SurfacePoint>& corners = solver_->drawing().corners();
  const SurfaceCurve& taut = this->taut(attempt).curve;
  return largest_turn_between(solver_->drawing().surface(), taut, corners) <= kMostFairTurn &&
         keeps_within(attempt.group, taus, taut);
}

/// Whether a fair curve can be accepted without comparison with the taut curve: it turns little,
/// and the walls are near. Between distant walls, a curve that turns little may still be far from
/// the drawing.
bool FairFinishing::needs_no_taut(const FairGroup& group, const Taus& taus,
                                  const SurfaceCurve& curve) const {
  constexpr double kHeld = 1.0 / 8;  // times the length
  const EmbeddedDrawing& drawing = solver_->drawing();
  return solver_->largest_wall(group, taus) <= kHeld * group.length &&
         is_clearly_fair(drawing.surface(), curve, drawing.corners(), group.edge);
}

/// The fair curve of the next try: from the chain, then from the taut curve, then from the drawing
/// in narrower and narrower bands; with legs, from the taut curve with increasing tension. Empty if
/// the result is beyond its walls or worse than the start curve.
std::optional<SurfaceCurve> FairFinishing::tried(Attempt& attempt, const Taus& taus) {
  const EmbeddedDrawing& drawing = solver_->drawing();
  const Surface& surface = drawing.surface();
  const FairGroup& group = attempt.group;
  const bool any_legs = has_legs(drawing, group);
  std::optional<LegStart> legs = LegStart{};
  if (any_legs) {
    legs = leg_start(drawing, group, taut(attempt).curve, tension_of(taus.front()));
    if (!legs) return std::nullopt;
    legs->tension.factors = attempt.tighter;
  } else if (attempt.tries == kFromTaut && !taut(attempt).is_close) {
    return std::nullopt;
  }
  std::optional<SurfaceCurve> result = faired(attempt, taus, *legs);
  if (result && !any_legs && needs_no_taut(group, taus, *result)) return result;
  if (!any_legs && is_straight(attempt)) return taut(attempt).curve;
  std::vector<SurfacePoint> bad;
  if (result && has_more_boundary_points(surface, *result, taut(attempt).curve)) {
    bad = boundary_points_of(surface, *result, taut(attempt).curve);
  } else if (result && bends_more(attempt, *result)) {
    bad = bends_more_at(attempt, *result);
    if (!any_legs && !attempt.bent) attempt.bent = result;
  } else if (result) {
    return result;
  }
  if (any_legs) tighten(attempt, bad, result ? *result : taut(attempt).curve);
  return std::nullopt;
}

/// The fair curve of the current try, if it is between its walls.
std::optional<SurfaceCurve> FairFinishing::faired(Attempt& attempt, const Taus& taus,
                                                  const LegStart& legs) {
  const EmbeddedDrawing& drawing = solver_->drawing();
  const FairGroup& group = attempt.group;
  const bool any_legs = has_legs(drawing, group);
  std::optional<SurfaceCurve> result;
  const double band = kBands[attempt.tries];
  solver_->with_fairing(group, taus, band, legs.tension, poller_, [&](CurveFairing& fairing) {
    const auto start = [&] {
      if (!any_legs) {
        return attempt.tries == kFromTaut ? solver_->traced(group, taut(attempt).curve)
                                          : solver_->traced(group);
      }
      CurveTrace trace = trace_through(drawing.surface(), taut(attempt).curve, legs.fixed);
      trace.set_corners(drawing.corners());
      return trace;
    };
    const auto own =
        !any_legs && attempt.tries == 0 ? attempt.chain : fairing.from_curve(start(), poller_);
    if (fairing.passes_too_many_faces()) attempt.tries = kTries - 1;
    if (!own) return;
    auto fair = fairing.curve_of(*own, poller_);
    if (fair && fair->farthest <= 1) result = std::move(fair->curve);
  });
  return result;
}

/// Whether a curve lies between the walls.
bool FairFinishing::keeps_within(const FairGroup& group, const Taus& taus,
                                 const SurfaceCurve& curve) {
  bool within = false;
  solver_->with_fairing(group, taus, 1, {}, poller_, [&](const CurveFairing& fairing) {
    within = fairing.farthest(curve) <= 1;
  });
  return within;
}

}  // namespace talweg

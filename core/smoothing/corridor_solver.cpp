#include "talweg/core/smoothing/corridor_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/lifting/straight_legs.hpp"
#include "talweg/core/lifting/touched_edges.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_valleys.hpp"
#include "talweg/core/space/nearest_segment.hpp"

namespace talweg {
namespace {

// A lift has no effect if it lengthens no edge by more than this fraction of the edge's length.
constexpr double kUnfelt = 1e-7;

/// The distance from the drawing to the walls of a fair curve, in slacks.
double walls_of(double tau) { return 1.25 * (1 + 0.2 / tau); }

constexpr double kLeastSlack = 1.0 / 8;  // edges
constexpr double kRounding = 1e-9;       // edges
constexpr double kDetour = 6;      // slacks: a part of the drawing farther away is not trembling
constexpr double kMostGrowth = 8;  // factor in a curve's length during fairing
constexpr int kHalvings = 8;

}  // namespace

/// The distance up to which δ must be exact if rough walls suffice: the faces of the curve lie
/// within the slack plus one edge.
double CorridorSolver::exact_for_walls() const {
  const std::vector<double>& near = drawing_->drawing().edges_near();
  double exact = 0;
  for (std::size_t c = 0; c < valleys_->size(); ++c) {
    // While dragging, more valleys than curves exist: valleys of curves near the dragged curve.
    exact = std::max(exact, largest_slack((*valleys_)[c]) + near[std::min(c, near.size() - 1)]);
  }
  return exact;
}

/// The potential of the valleys. While dragging, all valleys have the tau of the dragged curve.
Corridor CorridorSolver::corridor(const SmoothingOptions& options) const {
  std::vector<double> taus;
  for (std::size_t c = 0; c < valleys_->size(); ++c) taus.push_back(options.tau_of(c));
  return {*distance_, taus, *valleys_};
}

Straightened CorridorSolver::straighten(const SmoothingOptions& options,
                                        const std::vector<Walls>& walls, const Progress& progress) {
  if (drawing_->all_legs()) return straighten_flat(options, progress);
  Straightened result = straighten_lifted(options, walls, progress);
  if (!drawing_->any_legs()) return result;
  const std::vector<SurfaceCurve> strokes = std::move(result.curves);
  const auto put_in = [&](const Straightened& flat) {
    result.curves = strokes;
    for (std::size_t c = 0; c < strokes.size(); ++c) {
      const DrawnLegs& legs = drawing_->legs()[c];
      if (legs.any()) result.curves[c] = with_legs(legs, strokes[c], flat.curves[c]);
    }
    result.time_ms.straighten += flat.time_ms.straighten;
    result.time_ms.trace += flat.time_ms.trace;
    result.at_fence = result.at_fence || flat.at_fence;
  };
  const auto legs = drawing_->straighten_legs(options, progress);
  if (legs) put_in(*legs);
  if (!legs || legs_meet(drawing_->surface(), result.curves, drawing_->legs())) {
    put_in(straighten_flat(options, progress));
  }
  return result;
}

Straightened CorridorSolver::straighten_lifted(const SmoothingOptions& options,
                                               const std::vector<Walls>& walls,
                                               const Progress& progress) {
  const Corridor corridor = this->corridor(options);
  std::vector<bool> exactly;
  exactly.reserve(walls.size());
  for (const Walls each : walls) exactly.push_back(each == Walls::kExact);
  const bool all = std::find(exactly.begin(), exactly.end(), false) == exactly.end();
  const double exact = all ? HUGE_VAL : exact_for_walls();
  const std::size_t own = drawing_->surface().vertex_count();
  const auto metric = [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {  // φ = 0 at inserted vertices: they lie on the drawing
      return v.index() < own ? corridor.at_vertex_bounded(v, exact, exactly)
                             : std::array<double, 2>{0, 0};
    };
    return lifted_length(length, at(p), at(q));
  };
  ProgressPoller poller(progress, "straighten");
  const ScopedPoller scoped(*distance_, poller);
  return drawing_->straighten(options, metric, progress);
}

Straightened CorridorSolver::straighten_flat(const SmoothingOptions& options,
                                             const Progress& progress) {
  return drawing_->straighten_flat(options, progress);
}

/// Whether the lift would change an edge length that the straightening has used. The lengths of
/// ways along edges from the drawing bound the distances of these edges.
bool CorridorSolver::is_felt(const Corridor& corridor, const Straightened& flat,
                             const Progress& progress) const {
  const TouchedEdges edges =
      touched_edges(drawing_->surface(), flat.touched, drawing_->drawing().curves(), progress);
  return !(corridor.largest_lengthening(edges.farthest, edges.shortest) <= kUnfelt);
}

std::optional<Straightened> CorridorSolver::unlifted(const SmoothingOptions& options,
                                                     const Progress& progress) {
  double most = 0;
  for (std::size_t c = 0; c < valleys_->size(); ++c) most = std::max(most, options.tau_of(c));
  if (most == 0) return straighten_flat(options, progress);
  // Straightening without the lift is tried only if the lift has no effect up to a sixteenth of the
  // drawing's radius beyond the slack.
  const Corridor corridor = this->corridor(options);
  double beyond = HUGE_VAL, slack = 0;
  for (const Corridor::Valley& valley : *valleys_) {
    beyond = std::min(beyond, valley.length / 4);
    slack = std::max(slack, largest_slack(valley));
  }
  if (corridor.largest_lengthening(slack + beyond, beyond) > kUnfelt) return std::nullopt;
  SmoothingOptions lazy = options;
  lazy.prepare_whole_mesh = false;  // only the touched lengths matter
  Straightened flat = straighten_flat(lazy, progress);
  if (is_felt(corridor, flat, progress)) return std::nullopt;
  return options.prepare_whole_mesh ? straighten_flat(options, progress) : std::move(flat);
}

/// Whether straightening has lost nearly all of an open curve, because its ends are close together.
bool CorridorSolver::has_lost_all(const SmoothingOptions& options, const Straightened& straight,
                                  std::size_t curve) const {
  constexpr double kLost = 0.25;  // fraction of the drawing's length
  const SurfaceCurve& drawn = drawing_->drawing().curves()[curve];
  if (drawing_->erases_loops()) return false;  // the short remainder is intended
  if (drawn.closed || drawing_->legs()[curve].any() || options.tau_of(curve) < kLeastHeldTau) {
    return false;
  }
  const double length = curve_length(drawing_->surface(), straight.curves[curve]);
  if (length > kLost * drawing_->drawing().measures()[curve].length) return false;
  const NearestSegment taut(
      segments_of(positions_of(drawing_->mesh(), straight.curves[curve]), false));
  const double far = kDetour * largest_slack((*valleys_)[curve]);
  const std::vector<Point> points = positions_of(drawing_->mesh(), drawn);
  return std::any_of(points.begin(), points.end(),
                     [&](const Point& p) { return taut.to(p).distance > far; });
}

void CorridorSolver::reset_lost_curves(const SmoothingOptions& options,
                                       Straightened& straight) const {
  for (std::size_t c = 0; c < drawing_->capped().size(); ++c) {
    if (!is_faired(options, c)) continue;
    StraightenedPath& path = straight.paths[c];
    const bool collapsed =
        drawing_->capped()[c].closed && path.termination == Termination::kCollapsed;
    if (!collapsed && !has_lost_all(options, straight, c)) continue;
    straight.curves[c] =
        drawing_->drawing()
            .curves()[c];  // not the capped curve: capping can cut through a small loop
    path.length_after = path.length_before;
    path.termination = Termination::kConverged;
  }
}

std::vector<FairGroup> CorridorSolver::groups(const SmoothingOptions& options) const {
  const auto is_free = [&](std::size_t c) {
    return is_faired(options, c) && (drawing_->legs()[c].any() || !is_narrow(c));
  };
  const auto may_join = [&](std::size_t a, std::size_t b) {
    const bool legs = drawing_->legs()[a].any() || drawing_->legs()[b].any();
    return drawing_->options().join_ends && is_free(a) && is_free(b) &&
           (!legs || options.tau_of(a) == options.tau_of(b));
  };
  std::vector<FairGroup> groups;
  for (JoinedCurves& curves : joined_curves(drawing_->surface(), drawing_->drawing().curves(),
                                            drawing_->corners(), may_join)) {
    groups.push_back(fair_group(*drawing_, std::move(curves)));
  }
  return groups;
}

/// The trace of a start curve for fairing.
CurveTrace CorridorSolver::traced(const SurfaceCurve& curve,
                                  std::span<const SurfacePoint> fixed) const {
  CurveTrace trace = trace_of(drawing_->surface(), curve, fixed);
  trace.set_corners(drawing_->corners());
  return trace;
}

CurveTrace CorridorSolver::traced(const FairGroup& group, const SurfaceCurve& curve) const {
  if (group.junctions.empty()) return traced(curve, drawing_->fixed());
  std::vector<SurfacePoint> fixed = drawing_->fixed();
  fixed.insert(fixed.end(), group.junctions.begin(), group.junctions.end());
  return traced(curve, fixed);
}

CurveTrace CorridorSolver::traced(const FairGroup& group) const {
  CurveTrace trace = traced(group, group.drawn);
  trace.set_drawn();
  return trace;
}

BandWidth CorridorSolver::width_of(std::size_t curve, double tau, double narrower) const {
  const Corridor::Valley& valley = (*valleys_)[curve];
  return {valley.slack, valley.slack_at, kLeastSlack * drawing_->drawing().edges_near()[curve],
          narrower * walls_of(tau), valley.apart};
}

double CorridorSolver::largest_wall(const FairGroup& group, const Taus& taus) const {
  double widest = 0;
  for (std::size_t k = 0; k < taus.size(); ++k) {
    const std::size_t c = group.joined.parts[k].curve;
    const BandWidth width = width_of(c, taus[k], 1);
    const double slack = std::max(largest_slack((*valleys_)[c]), width.least_slack);
    widest = std::max(widest, std::min(width.wall_in_slacks * slack, width.largest_wall));
  }
  return widest;
}

void CorridorSolver::with_fairing(const FairGroup& group, const Taus& taus, double narrower,
                                  const LegTension& legs, ProgressPoller& poller,
                                  const std::function<void(CurveFairing&)>& use) {
  const ScopedPoller scoped(*distance_, poller);
  const auto centering = [](double tau) { return std::min(1.0, std::pow(tau, 4)); };
  FairOptions options;
  options.centering *= centering(taus.front());
  std::vector<BandCurve> curves;
  bool all_legs = true;
  double begin = 0;
  for (std::size_t k = 0; k < taus.size(); ++k) {
    const std::size_t c = group.joined.parts[k].curve;
    BandWidth width = width_of(c, taus[k], narrower);
    if (taus[k] != taus.front()) width.centering = centering(taus[k]) / centering(taus.front());
    curves.push_back({c, width, begin, group.joined.parts[k].reversed});
    begin += drawing_->drawing().measures()[c].length;
    all_legs = all_legs && drawing_->legs()[c].all();
  }
  std::optional<DrawnBand> band;
  if (!all_legs) band.emplace(*distance_, curves, group.line.get());
  CurveFairing fairing(drawing_->curvature(), band ? &*band : nullptr, group.edge, options, legs);
  fairing.give_up_beyond(kMostGrowth * (group.length + 2 * largest_wall(group, taus)));
  use(fairing);
}

std::optional<SampleChain> CorridorSolver::fair_from(const FairGroup& group, const Taus& taus,
                                                     const TautCurves& taut,
                                                     const Progress& progress) {
  std::optional<SampleChain> chain;
  if (has_legs(*drawing_, group)) return chain;
  const bool is_held = *std::min_element(taus.begin(), taus.end()) >= kLeastHeldTau;
  ProgressPoller poller(progress, "fair");
  with_fairing(group, taus, 1, {}, poller, [&](CurveFairing& fairing) {
    if (!is_held) {
      chain = fairing.from_curve(traced(group, joined(group.joined, taut().curves)), poller);
      if (chain && fairing.keeps_within(*chain)) return;
    }
    auto own = fairing.from_curve(traced(group), poller);
    if (own) chain = std::move(own);
  });
  return chain;
}

std::optional<SampleChain> CorridorSolver::fair_from(const FairGroup& group, const Taus& taus,
                                                     const SampleChain& chain, SampleTrail& trail,
                                                     const Progress& progress) {
  ProgressPoller poller(progress, "fair");
  std::optional<SampleChain> result;
  with_fairing(group, taus, 1, {}, poller,
               [&](CurveFairing& fairing) { result = fairing.from_chain(chain, trail, poller); });
  return result;
}

bool CorridorSolver::keeps_within_walls(const FairGroup& group, const Taus& taus,
                                        const SampleChain& chain, const Progress& progress) {
  ProgressPoller poller(progress, "fair");
  bool result = false;
  with_fairing(group, taus, 1, {}, poller, [&](CurveFairing& fairing) {
    const auto curve = fairing.curve_of(chain, poller);
    result = curve && curve->farthest <= 1;
  });
  return result;
}

std::optional<SampleChain> CorridorSolver::resampled(const FairGroup& group, const Taus& taus,
                                                     const SampleChain& chain,
                                                     const Progress& progress) {
  ProgressPoller poller(progress, "fair");
  std::optional<SampleChain> result;
  with_fairing(group, taus, 1, {}, poller,
               [&](CurveFairing& fairing) { result = fairing.resampled(chain, poller); });
  return result;
}

std::optional<SampleChain> CorridorSolver::between(const FairGroup& group, const AtTaus& from,
                                                   const AtTaus& to, const SampleTrail& trail,
                                                   const Taus& taus, const Progress& progress) {
  ProgressPoller poller(progress, "fair");
  const std::vector<std::size_t> part_of = group.parts_of_stretches(from.chain);
  ChainMaker maker(drawing_->surface());
  // The chain at the interpolated parameter of the walls (`nearer` = 0), or moved towards the chain
  // with the nearer walls (1).
  const auto at = [&](double nearer) {
    std::vector<double> parts, all;
    for (std::size_t k = 0; k < taus.size(); ++k) {
      // The distance of the walls is linear in 1 / tau.
      const double part = (1 / taus[k] - 1 / from.taus[k]) / (1 / to.taus[k] - 1 / from.taus[k]);
      const double near = to.taus[k] > from.taus[k] ? 1 : 0;
      parts.push_back(part + nearer * (near - part));
    }
    for (std::size_t i = 0; i < from.chain.size(); ++i) {
      const bool end = from.chain.is_end(i);
      all.push_back(parts[end ? 0 : part_of[from.chain.join_before(i).stretch]]);
    }
    return maker.between(from.chain, to.chain, trail, all);
  };
  std::optional<SampleChain> result;
  with_fairing(group, taus, 1, {}, poller, [&](CurveFairing& fairing) {
    result = at(0);
    if (!result || fairing.keeps_within(*result)) return;
    double out = 0, in = 1;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = (out + in) / 2;
      auto chain = at(middle);
      if (!chain) return;
      if (fairing.keeps_within(*chain)) {
        in = middle;
        result = std::move(chain);
      } else {
        out = middle;
      }
    }
  });
  return result;
}

std::optional<SurfaceCurve> CorridorSolver::fair(double tau, const SurfaceCurve& curve,
                                                 std::span<const SurfacePoint> fixed,
                                                 const Progress& progress) {
  ProgressPoller poller(progress, "fair");
  std::optional<SurfaceCurve> result;
  with_fairing(fair_group(*drawing_, {{{0, false}}}), {tau}, 1, {}, poller,
               [&](CurveFairing& fairing) {
                 const auto chain = fairing.from_curve(traced(curve, fixed), poller);
                 if (!chain) return;
                 if (auto faired = fairing.curve_of(*chain, poller))
                   result = std::move(faired->curve);
               });
  return result;
}

/// The result in a band too narrow for fairing: the taut curve; but the drawing if it turns less,
/// or if the taut curve is beyond the walls of a given slack.
const SurfaceCurve& CorridorSolver::in_narrow_band(double tau, std::size_t curve,
                                                   const SurfaceCurve& taut,
                                                   ProgressPoller& poller) {
  const ScopedPoller scoped(*distance_, poller);
  const SurfaceCurve& drawn = drawing_->drawing().curves()[curve];
  const auto turning = [&](const SurfaceCurve& c) {
    return measure_curve(drawing_->surface(), c).total_curvature;
  };
  const Corridor::Valley& valley = (*valleys_)[curve];
  if (turning(taut) > turning(drawn)) return drawn;
  if (!valley.slack_from_options) return taut;
  const double edge = drawing_->drawing().edges_near()[curve];
  const DrawnBand band(
      *distance_, curve,
      {valley.slack, valley.slack_at, kRounding * edge, walls_of(tau), valley.apart});
  const CurveFairing fairing(drawing_->curvature(), &band, edge, {});
  return fairing.farthest(taut) <= 1 ? taut : drawn;
}

/// Whether the slack is less than an eighth of an edge: such a band has room for straight lines
/// only.
bool CorridorSolver::is_narrow(std::size_t curve) const {
  return largest_slack((*valleys_)[curve]) < kLeastSlack * drawing_->drawing().edges_near()[curve];
}

}  // namespace talweg

#include "talweg/core/smoothing/corridor_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_valleys.hpp"
#include "talweg/core/smoothing/leg_start.hpp"
#include "talweg/core/smoothing/lifted_lengths.hpp"
#include "talweg/core/smoothing/touched_edges.hpp"

namespace talweg {
namespace {

// A lift counts as none if it lengthens no edge by more than this part of the edge's length.
constexpr double kUnfelt = 1e-7;

/// How far from the drawing the walls are that a fair curve keeps to, in slacks.
double walls_of(double tau) { return 1.25 * (1 + 0.2 / tau); }

constexpr double kNoTurn = 1e-6;         // rad
constexpr double kLeastSlack = 1.0 / 8;  // edges
constexpr int kHalvings = 8;
constexpr double kBands[] = {1, 0.7, 0.4};  // of tries that start from the drawing
constexpr std::size_t kTries = 1 + std::size(kBands);

/// c of a spline's legs: see LegTension::relative. Below the least one it would swing out widely
/// where its legs turn sharply.
double tension_of(double tau) { return std::max(1.0, 20 * tau); }
constexpr double kTighter = 8;  // of the tries of splines
constexpr const char* kLeftTaut =
    "The curve could not be made fair within its walls; it is left taut, with kinks.";

/// Whether a point is at the boundary, or as near as rounding tells.
bool is_at_boundary(const Surface& surface, const SurfacePoint& point) {
  constexpr double kAtIt = 1e-6;  // of the face's height
  for (const FaceId face : faces_at(surface, point)) {
    const auto b = coordinates_in(surface, point, face).barycentric;
    HalfedgeId side = surface.halfedge(face);  // from corner 0 to corner 1
    for (std::size_t k = 0; k < 3; ++k, side = surface.next(side)) {
      if (surface.on_boundary(edge_of(side)) && b[(k + 2) % 3] <= kAtIt) return true;
    }
  }
  return false;
}

/// How many of a curve's points are at the boundary.
std::size_t boundary_points(const Surface& surface, const SurfaceCurve& curve) {
  return static_cast<std::size_t>(std::ranges::count_if(
      curve.points, [&](const SurfacePoint& point) { return is_at_boundary(surface, point); }));
}

/// Whether a curve lies along the boundary where the taut one at most ends there.
bool is_pressed(const Surface& surface, const SurfaceCurve& curve, const SurfaceCurve& taut) {
  const std::size_t by_itself = boundary_points(surface, taut);
  return by_itself <= 2 && boundary_points(surface, curve) > by_itself;
}

}  // namespace

/// How far out δ must be exact where the valley is narrow: the faces that the curve passes through
/// lie within the slack plus one edge.
double CorridorHold::exact_for_walls() const {
  const std::vector<double>& near = drawing_->drawing().edges_near();
  double exact = 0;
  for (std::size_t c = 0; c < valleys_->size(); ++c) {
    // While dragging, there are also valleys of curves that are only near the dragged one.
    exact = std::max(exact, largest_slack((*valleys_)[c]) + near[std::min(c, near.size() - 1)]);
  }
  return exact;
}

Straightened CorridorHold::straighten(const SmoothingOptions& options, Walls walls,
                                      const Progress& progress) {
  if (drawing_->all_legs()) return straighten_flat(options, progress);
  Straightened result = straighten_lifted(options, walls, progress);
  if (!drawing_->any_legs()) return result;
  const Straightened flat = straighten_flat(options, progress);
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    const DrawnLegs& legs = drawing_->legs()[c];
    if (legs.any()) result.curves[c] = with_legs(legs, result.curves[c], flat.curves[c]);
  }
  result.time_ms.straighten += flat.time_ms.straighten;
  result.time_ms.trace += flat.time_ms.trace;
  return result;
}

Straightened CorridorHold::straighten_lifted(const SmoothingOptions& options, Walls walls,
                                             const Progress& progress) {
  const Corridor corridor = this->corridor(options.tau);
  const double exact = walls == Walls::kExact ? HUGE_VAL : exact_for_walls();
  const std::size_t own = drawing_->surface().vertex_count();
  const auto metric = [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {  // inserted vertices lie on the drawing
      return v.index() < own ? corridor.at_vertex_roughly(v, exact) : std::array<double, 2>{0, 0};
    };
    return lifted_length(length, at(p), at(q));
  };
  Asker asker(progress, "straighten");
  const AskedDuring asked(*distance_, asker);
  return drawing_->straighten(options, metric, progress);
}

Straightened CorridorHold::straighten_flat(const SmoothingOptions& options,
                                           const Progress& progress) {
  return drawing_->straighten(options, unlifted_length, progress);
}

/// Whether the lift would have changed one of the lengths that the straightening used. The ways
/// from the drawing along those edges bound their distance.
bool CorridorHold::is_felt(const Corridor& corridor, const Straightened& flat,
                           const Progress& progress) const {
  const TouchedEdges edges =
      touched_edges(drawing_->surface(), flat.touched, drawing_->drawing().curves(), progress);
  return !(corridor.largest_lengthening(edges.farthest, edges.shortest) <= kUnfelt);
}

std::optional<Straightened> CorridorHold::unlifted(const SmoothingOptions& options,
                                                   const Progress& progress) {
  if (options.tau == 0) return straighten_flat(options, progress);
  // Straightening without the lift is worth trying only if the lift would not be felt a sixteenth
  // of the drawing's radius beyond the slack.
  const Corridor corridor = this->corridor(options.tau);
  double beyond = HUGE_VAL, slack = 0;
  for (const Corridor::Valley& valley : *valleys_) {
    beyond = std::min(beyond, valley.length / 4);
    slack = std::max(slack, largest_slack(valley));
  }
  if (corridor.largest_lengthening(slack + beyond, beyond) > kUnfelt) return std::nullopt;
  SmoothingOptions lazy = options;
  lazy.prepare_whole_mesh = false;  // only the lengths it touches decide
  Straightened flat = straighten_flat(lazy, progress);
  if (is_felt(corridor, flat, progress)) return std::nullopt;
  return options.prepare_whole_mesh ? straighten_flat(options, progress) : std::move(flat);
}

void CorridorHold::hold_thin_loops(Straightened& straight) const {
  for (std::size_t c = 0; c < drawing_->capped().size(); ++c) {
    StraightenedPath& path = straight.paths[c];
    if (!drawing_->capped()[c].closed || path.termination != Termination::kCollapsed) continue;
    straight.curves[c] = drawing_->drawing().curves()[c];  // capping can cut through it
    path.length_after = path.length_before;
    path.termination = Termination::kConverged;
  }
}

/// Calls use() with the fairing of one curve.
void CorridorHold::with_fairing(double tau, double narrower, std::size_t curve,
                                const LegTension& legs, Asker& asker,
                                const std::function<void(CurveFairing&)>& use) {
  const AskedDuring asked(*distance_, asker);
  const Corridor::Valley& valley = (*valleys_)[curve];
  const double edge = drawing_->drawing().edges_near()[curve];
  std::optional<DrawnBand> band;
  if (!drawing_->legs()[curve].all()) {
    band.emplace(*distance_, drawing_->surface(), curve,
                 BandWidth{valley.slack, valley.slack_at, kLeastSlack * edge,
                           narrower * walls_of(tau), valley.apart});
  }
  FairOptions options;
  options.middle *= std::min(1.0, std::pow(tau, 4));
  CurveFairing fairing(drawing_->surface(), band ? &*band : nullptr, edge, options, legs);
  use(fairing);
}

FairChains CorridorHold::fair_from(double tau, std::span<const SurfaceCurve> curves,
                                   const Progress& progress) {
  Asker asker(progress, "fair");
  FairChains chains(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (has_legs(c)) continue;
    with_fairing(tau, 1, c, {}, asker, [&](CurveFairing& fairing) {
      const auto from = [&](const SurfaceCurve& curve) {
        return fairing.from_curve(trace_of(drawing_->surface(), curve, drawing_->fixed()), asker);
      };
      chains[c] = from(curves[c]);
      // What straightening has cut off may lie beyond walls that no step leads back through.
      if (chains[c] && fairing.keeps_within(*chains[c])) return;
      std::optional<SampleChain> again = from(drawing_->drawing().curves()[c]);
      if (again) chains[c] = std::move(again);
    });
  }
  return chains;
}

FairChains CorridorHold::fair_from(double tau, const FairChains& chains,
                                   std::vector<SampleTrail>& trails, const Progress& progress) {
  Asker asker(progress, "fair");
  FairChains result = chains;
  trails.resize(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (!chains[c]) continue;
    with_fairing(tau, 1, c, {}, asker, [&](CurveFairing& fairing) {
      result[c] = fairing.from_chain(*chains[c], trails[c], asker);
    });
  }
  return result;
}

std::optional<SampleChain> CorridorHold::between(std::size_t curve, const AtTau& from,
                                                 const AtTau& to, const SampleTrail& trail,
                                                 double tau, const Progress& progress) {
  Asker asker(progress, "fair");
  std::optional<SampleChain> result;
  with_fairing(tau, 1, curve, {}, asker, [&](CurveFairing& fairing) {
    // The walls' distance is linear in 1 / tau.
    const double part = (1 / tau - 1 / from.tau) / (1 / to.tau - 1 / from.tau);
    const double nearer = to.tau > from.tau ? 1 : 0;
    ChainMaker maker(drawing_->surface());
    const auto at = [&](double p) { return maker.between(from.chain, to.chain, trail, p); };
    result = at(part);
    if (!result || fairing.keeps_within(*result)) return;
    double out = part, in = nearer;
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

std::optional<SurfaceCurve> CorridorHold::fair(double tau, const SurfaceCurve& curve,
                                               std::span<const SurfacePoint> fixed,
                                               const Progress& progress) {
  Asker asker(progress, "fair");
  std::optional<SurfaceCurve> result;
  with_fairing(tau, 1, 0, {}, asker, [&](CurveFairing& fairing) {
    const auto chain = fairing.from_curve(trace_of(drawing_->surface(), curve, fixed), asker);
    if (!chain) return;
    if (auto faired = fairing.curve_of(*chain, asker)) result = std::move(faired->curve);
  });
  return result;
}

/// The fair curve of one try: from the chain, then from the drawing in ever narrower bands; with
/// legs from the taut curve, ever tighter. None if it is beyond its walls, bends more than the taut
/// one, or touches the boundary where that keeps off it.
std::optional<SurfaceCurve> CorridorHold::tried(std::size_t number, double tau, std::size_t curve,
                                                const std::optional<SampleChain>& chain,
                                                const SurfaceCurve& taut, Asker& asker) {
  const Surface& surface = drawing_->surface();
  std::optional<SurfaceCurve> result;
  const DrawnLegs& drawn = drawing_->legs()[curve];
  std::optional<LegStart> legs = LegStart{};
  if (drawn.any()) legs = start_on(drawn, taut, tension_of(tau) * std::pow(kTighter, number));
  if (!legs) return result;
  const double band = number == 0 ? 1 : kBands[number - 1];
  with_fairing(tau, band, curve, legs->tension, asker, [&](CurveFairing& fairing) {
    const auto start = [&] {
      return drawn.any()
                 ? trace_through(surface, taut, legs->fixed)
                 : trace_of(surface, drawing_->drawing().curves()[curve], drawing_->fixed());
    };
    const auto own = !drawn.any() && number == 0 ? chain : fairing.from_curve(start(), asker);
    if (!own) return;
    auto faired = fairing.curve_of(*own, asker);
    if (faired && faired->farthest <= 1) result = std::move(faired->curve);
  });
  const double edge = drawing_->drawing().edges_near()[curve];
  const auto bending = [&](const SurfaceCurve& c) {
    return measure_curve(surface, c, edge).bending;
  };
  const bool worse =
      result && (bending(*result) > bending(taut) || is_pressed(surface, *result, taut));
  return worse ? std::nullopt : result;
}

void CorridorHold::finish(double tau, const FairChains& chains, std::vector<SmoothedCurve>& curves,
                          const Progress& progress) {
  Asker asker(progress, "fair");
  const auto turning = [&](const SurfaceCurve& curve) {
    return measure_curve(drawing_->surface(), curve).total_curvature;
  };
  std::vector<SurfaceCurve> taut, now;
  std::vector<std::size_t> tries(curves.size(), 0);
  const auto make_fair = [&](std::size_t c) {
    std::optional<SurfaceCurve> fair;
    while (!fair && tries[c] < kTries) {
      fair = tried(tries[c]++, tau, c, chains[c], taut[c], asker);
    }
    if (!fair) {
      curves[c].warnings.emplace_back(kLeftTaut);
      tries[c] = kTries + 1;
    }
    now[c] = fair ? *std::move(fair) : taut[c];
  };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const SurfaceCurve& drawn = drawing_->drawing().curves()[c];
    taut.push_back(curves[c].curve);
    now.push_back(curves[c].curve);
    if (is_narrow(c) && !has_legs(c)) {
      if (turning(taut[c]) > turning(drawn)) now[c] = drawn;
    } else if (turning(taut[c]) >= kNoTurn) {  // what is straight is fair
      make_fair(c);
    }
  }
  // Each curve is faired separately, so that curves near each other, or strands of one, may cross.
  for (bool again = !curves.empty(); again;) {
    again = false;
    for (const std::size_t c : crossing_curves(drawing_->surface(), now)) {
      if (tries[c] == 0 || tries[c] > kTries) continue;
      make_fair(c);
      again = true;
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c) curves[c].curve = std::move(now[c]);
}

/// A band much narrower than the mesh's edges has no room for more than straight lines.
bool CorridorHold::is_narrow(std::size_t curve) const {
  return largest_slack((*valleys_)[curve]) < kLeastSlack * drawing_->drawing().edges_near()[curve];
}

}  // namespace talweg

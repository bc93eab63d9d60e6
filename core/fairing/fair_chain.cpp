#include "talweg/core/fairing/fair_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace talweg {
namespace {

constexpr int kWallRounds = 8, kTrials = 6, kHolds = 6;
constexpr double kJump = 0.02;  // rad
constexpr double kMostOfSpacing = 0.7;

double fourth(double x) { return x * x * x * x; }

void append(const ChainMove& move, SampleTrail& trail) {
  trail.resize(move.chain.size());
  for (std::size_t i = 0; i < trail.size(); ++i) {
    for (const HalfedgeId h : move.way(i)) add_crossing(trail[i], h);
  }
}

/// Replaces steps that almost equal the steps of another move by the steps of this move, so that
/// its samples are reused.
void take_over(const SampleChain& chain, const ChainMove& other, std::vector<double>& left) {
  constexpr double kAlmost = 1e-4;  // of a join
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (chain.fixed[i]) continue;
    const double join = std::min(chain.join_before(i).length, chain.join_after(i).length);
    if (std::abs(left[i] - other.left[i]) <= kAlmost * join) left[i] = other.left[i];
  }
}

}  // namespace

/// The energy of a loop measures the curvature against its mean, so that the loop keeps its size. A
/// loop of least bending would grow until it meets its outer wall. A loop with a corner counts as
/// an open curve.
double FairChain::mean_curvature(const SampleChain& chain) {
  if (!chain.closed) return 0;
  if (std::find(chain.corners.begin(), chain.corners.end(), true) != chain.corners.end()) return 0;
  return std::accumulate(chain.turns.begin(), chain.turns.end(), 0.0) / chain.length();
}

double FairChain::mean_of(const SampleChain& chain) const {
  if (has_legs()) return 0;
  return options_.mean ? *options_.mean : mean_curvature(chain);
}

bool FairChain::is_on_leg(const SampleChain& chain, std::size_t i) const {
  return has_legs() && !chain.is_end(i) && legs_->is_on_leg(chain.join_before(i)) &&
         legs_->is_on_leg(chain.join_after(i));
}

/// A freed sample has walls around its way-point; other samples on legs have no walls.
BandPlace FairChain::place_of(const SampleChain& chain, std::size_t i, double offset) const {
  constexpr double kScale = 2;  // of a step, in joins
  if (is_freed(chain, i) && !reach_.empty()) {
    const double r = reach_[i];
    return {std::abs(offset), offset < 0 ? -1.0 : 1.0, r, r, 0};
  }
  if (!is_freed(chain, i) && !is_on_leg(chain, i))
    return band_->at(chain.samples[i], turned_left(chain.tangent(i)));
  const double scale = kScale / 2 * (chain.join_before(i).length + chain.join_after(i).length);
  return {0, 0, scale, HUGE_VAL, 0};
}

/// Computes the places of the samples that `changed` marks; the places of other samples are known
/// already.
void FairChain::measure(const SampleChain& chain, const std::vector<double>& offsets,
                        const std::vector<bool>& changed, std::vector<BandPlace>& places) const {
  places.resize(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!chain.fixed[i] && changed[i]) places[i] = place_of(chain, i, offsets[i]);
  }
}

/// The share of a sample in the energy of the tension.
double FairChain::tension_energy_at(const SampleChain& chain, std::size_t i) const {
  if (tensions_.empty()) return 0;
  const std::size_t n = chain.joins.size();
  double sum = 0;
  if (chain.closed || i > 0) {
    sum += tensions_[i == 0 ? n - 1 : i - 1] * chain.join_before(i).length;
  }
  if (i < n) sum += tensions_[i] * chain.joins[i].length;
  return sum / 2;
}

/// The bending of a join of a leg: its squared turns at vertices over its length.
double FairChain::bend_at(const SampleChain& chain, std::size_t join) const {
  const ChainJoin& j = chain.joins[join];
  if (!j.bends || !has_legs() || !legs_->is_on_leg(j)) return 0;
  return (j.first_turn * j.first_turn + (j.bends_once ? 0 : j.last_turn * j.last_turn)) / j.length;
}

/// ∫κ² ds and length of each leg.
std::vector<FairChain::LegBending> FairChain::bendings_of_legs(const SampleChain& chain) const {
  std::vector<LegBending> legs;
  const auto leg = [&](const ChainJoin& join) -> LegBending& {
    if (legs.size() <= join.stretch) legs.resize(join.stretch + 1);
    return legs[join.stretch];
  };
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i < chain.joins.size() && legs_->is_on_leg(chain.joins[i])) {
      leg(chain.joins[i]).length += chain.joins[i].length;
      leg(chain.joins[i]).bending += bend_at(chain, i);
    }
    if (!is_on_leg(chain, i) || chain.turns_freely(i)) continue;
    const ChainJoin &in = chain.join_before(i), &out = chain.join_after(i);
    const double half = chain.turns[i] * chain.turns[i] / (in.length + out.length);
    if (legs_->is_on_leg(in)) leg(in).bending += half;
    if (legs_->is_on_leg(out)) leg(out).bending += half;
    if (legs_->is_on_leg(in) != legs_->is_on_leg(out)) {
      leg(legs_->is_on_leg(in) ? in : out).bending += half;
    }
  }
  return legs;
}

/// Sets the tension to c ∫κ² ds / length of the present legs. Lower energy at this tension means a
/// lower product ∫κ² ds · length^c, too. A sharp bend, such as between two clicks side by side,
/// must not draw all other legs tight. The bending per length of a leg therefore counts for at most
/// five times the median of the legs, or, if more, for the bending of a turn of 1.8 rad over a leg
/// of the mean length.
void FairChain::balance(const SampleChain& chain) {
  if (!has_legs()) return;
  constexpr double kOfMedian = 5, kTurn = 1.8;  // rad
  std::vector<LegBending> legs = bendings_of_legs(chain);
  std::erase_if(legs, [](const LegBending& leg) { return !(leg.length > 0); });
  std::sort(legs.begin(), legs.end(), [](const LegBending& a, const LegBending& b) {
    return a.bending * b.length < b.bending * a.length;
  });
  double length = 0, squares = 0, before = 0, bending = 0, most = 0;
  for (const LegBending& leg : legs) {
    length += leg.length;
    squares += leg.length * leg.length;
  }
  for (const LegBending& leg : legs) {
    before += leg.length;
    if (before < length / 2) continue;
    most = kOfMedian * leg.bending / leg.length;
    break;
  }
  if (length > 0) most = std::max(most, kTurn * kTurn * length * length / (squares * squares));
  for (const LegBending& leg : legs) bending += std::min(leg.bending, most * leg.length);
  tension_ = legs_->tension.value_or(legs_->length_exponent * bending / length);
  tensions_.assign(chain.joins.size(), 0);
  for (std::size_t i = 0; i < tensions_.size(); ++i) {
    const ChainJoin& join = chain.joins[i];
    if (legs_->is_on_leg(join)) tensions_[i] = tension_ * legs_->factor(join);
  }
}

void FairChain::energies(const SampleChain& chain, const std::vector<BandPlace>& places,
                         std::vector<double>& energies) const {
  energies.assign(chain.size(), 0);
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const double half = bend_at(chain, i) / 2;
    energies[i] += half;
    energies[chain.after(i)] += half;
  }
  const double mean = mean_of(chain);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    energies[i] += tension_energy_at(chain, i);
    if (chain.turns_freely(i)) continue;
    const double weight = (chain.join_before(i).length + chain.join_after(i).length) / 2;
    const double turn = chain.turns[i] - mean * weight;
    energies[i] += turn * turn / weight;
    if (chain.fixed[i]) continue;
    const BandPlace& place = places[i];
    const double beyond = std::max(0.0, place.distance - options_.felt * place.wall);
    energies[i] += weight / fourth(place.slack) *
                   (options_.centering * place.centering * place.distance * place.distance +
                    stiffness_[i] * beyond * beyond);
  }
}

void FairChain::set_rows(const SampleChain& chain) {
  rows_.assign(chain.size(), {});
  std::vector<double> gauss(chain.size(), 0);
  if (has_legs()) gauss = curvature_->along(chain);
  const double mean = mean_of(chain);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.turns_freely(i)) continue;
    const ChainJoin &in = chain.join_before(i), &out = chain.join_after(i);
    Row& row = rows_[i];
    row.weight = (in.length + out.length) / 2;
    const double curvature = chain.turns[i] / row.weight;
    row.rest = curvature - mean;
    const double before = 1 / (row.weight * in.from_last_bend),
                 after = 1 / (row.weight * out.to_first_bend);
    // A join that bends at a vertex turns about this vertex, so the sample at its other end has no
    // part in the row.
    row.before = in.bends ? 0 : before;
    row.after = out.bends ? 0 : after;
    const double most = 1 / (row.weight * row.weight);
    row.here =
        -before - after + curvature * (curvature + mean) / 2 + std::clamp(gauss[i], -most, most);
  }
}

/// Assembles the system of a step without the walls, which change from round to round; solve() adds
/// them.
void FairChain::assemble(const SampleChain& chain) {
  system_.reset(chain.size(), chain.closed);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.turns_freely(i)) continue;
    const Row& row = rows_[i];
    const std::size_t at[3] = {chain.before(i), i, chain.after(i)};
    const double value[3] = {row.before, row.here, row.after};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b <= a; ++b)
        system_.add(at[a], at[b], row.weight * value[a] * value[b]);
      system_.right(at[a]) -= row.weight * value[a] * row.rest;
    }
    if (chain.fixed[i]) continue;
    const BandPlace& place = places_[i];
    const double per = row.weight / fourth(place.slack), s = place.slope;
    const double centering = options_.centering * place.centering;
    system_.add(i, i, per * (centering * s * s + damping_));
    system_.right(i) -= per * centering * s * place.distance;
  }
  add_tension(chain);
  add_bends(chain);
}

void FairChain::add_walls(const SampleChain& chain, BandSystem& system) const {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (active_[i] == 0) continue;
    const BandPlace& place = places_[i];
    const double slope = active_[i] * place.slope - options_.felt * place.wall_slope;
    const double beyond = active_[i] * place.distance - options_.felt * place.wall;
    const double per = rows_[i].weight / fourth(place.slack) * stiffness_[i];
    system.add(i, i, per * slope * slope);
    system.right(i) -= per * slope * beyond;
  }
}

/// Half of the gradient and of the Hessian of t · length. A sample that turns by θ and moves by d
/// to the left makes each of its joins shorter by sin(θ / 2) d.
void FairChain::add_tension(const SampleChain& chain) {
  for (std::size_t i = 0; i < tensions_.size(); ++i) {
    if (!(tensions_[i] > 0)) continue;
    const std::size_t j = chain.after(i);
    const ChainJoin& join = chain.joins[i];
    const double half = tensions_[i] / 2;
    system_.right(i) += half * std::sin(chain.turns[i] / 2);
    system_.right(j) += half * std::sin(chain.turns[j] / 2);
    system_.add(i, i, half / join.to_first_bend);
    system_.add(j, j, half / join.from_last_bend);
    if (!join.bends) system_.add(i, j, -half / join.length);
  }
}

/// Adds the rows of the turns at vertices. A sample that moves by d to the left raises the turn at
/// the next bend of its join by d / ℓ, where ℓ is the distance from the sample to the bend.
void FairChain::add_bends(const SampleChain& chain) {
  if (!has_legs()) return;
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const ChainJoin& join = chain.joins[i];
    if (!join.bends || !legs_->is_on_leg(join)) continue;
    const std::size_t j = chain.after(i);
    const double first = 1 / join.to_first_bend, last = 1 / join.from_last_bend,
                 per = 1 / join.length;
    system_.add(i, i, per * first * first);
    system_.add(j, j, per * last * last);
    if (join.bends_once) system_.add(i, j, per * first * last);
    system_.right(i) -= per * first * join.first_turn;
    system_.right(j) -= per * last * join.last_turn;
  }
}

/// Solves for a step and the walls that it touches, in rounds, because the step depends on the
/// walls and the walls on the step. The first try starts with the walls that are felt without a
/// step, a later try of the same step with the walls of the last try. A step may lead across the
/// drawing, and beyond the wall on the other side: on the drawing itself, rounding decides which
/// side has the positive distance.
bool FairChain::solve(const SampleChain& chain, bool first, std::vector<double>& left) {
  const auto felt_wall = [&](std::size_t i, double step) {
    if (chain.fixed[i]) return 0;
    const BandPlace& place = places_[i];
    const double there = place.distance + place.slope * step;
    const double wall = options_.felt * (place.wall + place.wall_slope * step);
    return std::abs(there) > wall ? (there < 0 ? -1 : 1) : 0;
  };
  active_.resize(chain.size());
  for (std::size_t i = 0; i < chain.size() && first; ++i) {
    active_[i] = felt_wall(i, 0);
  }
  for (int round = 0; round < kWallRounds; ++round) {
    with_walls_ = system_;
    add_walls(chain, with_walls_);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (held_[i] != 0) with_walls_.hold(i);
    }
    if (!with_walls_.solve(left)) return false;
    bool same = true;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const int active = felt_wall(i, left[i]);
      same = same && active == active_[i];
      active_[i] = active;
    }
    if (same) break;
  }
  return true;
}

void FairChain::limit(const SampleChain& chain, std::vector<double>& left) const {
  double part = 1;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i]) continue;
    part = std::min(part, places_[i].slack / std::abs(left[i]));
  }
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const double apart = std::abs(left[chain.after(i)] - left[i]);
    part = std::min(part, kMostOfSpacing * chain.joins[i].length / apart);
  }
  for (double& d : left) d *= part;
}

/// A join that passes over a vertex changes its turns by the angle defect of the vertex, which the
/// rows do not contain. Holds the samples where such a jump raises the energy; true if there are
/// any.
bool FairChain::hold_at_jumps(const SampleChain& chain, const SampleChain& moved,
                              const std::vector<double>& left, const std::vector<double>& now) {
  const std::size_t n = chain.size();
  std::vector<double> jumps(n, 0);
  const double mean = mean_of(chain);
  for (std::size_t i = 0; i < n; ++i) {
    if (chain.turns_freely(i)) continue;
    const Row& row = rows_[i];
    const double expected = row.rest + row.before * left[chain.before(i)] + row.here * left[i] +
                            row.after * left[chain.after(i)];
    jumps[i] = std::abs(moved.turns[i] - row.weight * (mean + expected));
  }
  bool any = false;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(jumps[i] > kJump && now[i] > energies_[i])) continue;
    for (const std::size_t k : {chain.before(i), i, chain.after(i)}) {
      if (held_[k] != 0 || !(k == i || jumps[k] > kJump)) continue;
      held_[k] = 1;
      any = true;
    }
  }
  return any;
}

/// Whether a place of a sample is between the walls, in the sample's own part of the band.
bool FairChain::is_inside(const SampleChain& chain, std::size_t i, const BandPlace& place) const {
  return place.distance <= place.wall && (chain.drawn.empty() || std::isnan(place.arc) ||
                                          band_->is_same_strand(place, chain.drawn[i]));
}

/// Holds the samples that are inside and that the step leads outside; true if there are any.
bool FairChain::hold_leaving(const SampleChain& chain, const SampleChain& moved,
                             const std::vector<BandPlace>& now) {
  bool any = false;
  if (chain.drawn.empty()) return any;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (held_[i] != 0 || is_inside(moved, i, now[i]) || !is_inside(chain, i, places_[i])) continue;
    held_[i] = 1;
    any = true;
  }
  return any;
}

/// Makes one step that lowers the energy; false if none is found.
bool FairChain::step(SampleChain& chain, SampleTrail* trail) {
  set_rows(chain);
  assemble(chain);
  held_.assign(chain.fixed.begin(), chain.fixed.end());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (is_freed(chain, i) && reach_.empty()) held_[i] = 1;
  }
  std::vector<double> left, now;
  std::vector<BandPlace> places;
  std::vector<double> offsets;
  std::optional<ChainMove> last;
  double part = 1;
  int holds = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    if (!solve(chain, trial == 0 && holds == 0, left)) return false;
    limit(chain, left);
    for (double& d : left) d *= part;
    if (last) take_over(chain, *last, left);
    auto move = maker_->moved_left(chain, left, last ? &*last : nullptr);
    passed_ += move ? move->chain.crossed.size() + move->walks.size() : chain.crossed.size();
    if (!move) {
      part /= 2;
      continue;
    }
    offsets = offsets_;
    for (std::size_t i = 0; i < left.size(); ++i) offsets[i] += left[i];
    measure(move->chain, offsets, move->changed, places);
    if (holds < kHolds && hold_leaving(chain, move->chain, places)) {
      ++holds;
      --trial;
      last = std::move(move);
      continue;
    }
    energies(move->chain, places, now);
    const double sum = std::accumulate(now.begin(), now.end(), 0.0);
    if (sum < energy_) {
      if (trail != nullptr) append(*move, *trail);
      chain = std::move(move->chain);
      offsets_.swap(offsets);
      places_.swap(places);
      energies_.swap(now);
      energy_ = sum;
      return true;
    }
    if (!hold_at_jumps(chain, move->chain, left, now)) part /= 2;
    last = std::move(move);
  }
  return false;
}

std::vector<std::size_t> FairChain::near_walls(const SampleChain& chain) const {
  constexpr double kAlmost = 0.98;
  std::vector<std::size_t> samples;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i] || places_[i].distance <= kAlmost * places_[i].wall) continue;
    samples.push_back(i);
  }
  return samples;
}

bool FairChain::stiffen(const SampleChain& chain) {
  constexpr double kStiffer = 10;
  const std::vector<std::size_t> samples = near_walls(chain);
  std::vector<bool> beyond(chain.size(), false);
  for (const std::size_t i : samples) {
    beyond[chain.before(i)] = beyond[i] = beyond[chain.after(i)] = true;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (beyond[i]) stiffness_[i] *= kStiffer;
  }
  return !samples.empty();
}

void FairChain::run(SampleChain& chain, SampleTrail* trail, ProgressPoller& poller) {
  stiffness_.resize(chain.size(), options_.stiffness);
  offsets_.resize(chain.size(), 0);
  damping_ = 1e-2;
  measure(chain, offsets_, std::vector<bool>(chain.size(), true), places_);
  const double tolerance = has_legs() ? options_.leg_tolerance : options_.tolerance;
  constexpr std::size_t kMostPassed = 1'000;  // faces, for each sample; drawings of hands pass 200
  int failed = 0;
  for (int iteration = 0; iteration < options_.max_iterations && failed < 3; ++iteration) {
    passes_too_many_faces_ = passed_ > kMostPassed * chain.size();
    if (passes_too_many_faces_) return;
    poller.add_work(chain.size() + chain.crossed.size() / 4);
    if (iteration == 0 || has_legs()) {
      balance(chain);
      energies(chain, places_, energies_);
      energy_ = std::accumulate(energies_.begin(), energies_.end(), 0.0);
    }
    if (poller.ends_early()) return;
    const double last = energy_;
    if (step(chain, trail)) {
      failed = 0;
      damping_ *= 0.3;
      if (last - energy_ < tolerance * last) return;
    } else {
      ++failed;
      damping_ *= 30;
    }
  }
}

}  // namespace talweg

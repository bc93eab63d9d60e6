#include "talweg/core/smoothing/fair_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/smoothing/fair_finishing.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr double kOrigin = 1, kMostRung = 64;

}  // namespace

std::optional<double> FairLadder::rung_of(const SmoothingOptions& options, std::size_t curve) {
  const double tau = options.tau_of(curve);
  const bool plain = options.finish_of(curve) == Finish::kFair && !options.max_iterations &&
                     options.min_relative_length == 0 && options.relax_rounds == 0;
  // For a smaller tau a result may be far from the drawing, and is computed without continuation.
  if (!plain || !(tau >= kLeastHeldTau)) return std::nullopt;
  const double power = std::log2(std::min(tau, kMostRung));
  return std::exp2(tau >= kOrigin ? std::floor(power) : std::ceil(power));
}

namespace {

/// The options of the straightening: tau = 1 for curves with a rung.
SmoothingOptions straightening(const SmoothingOptions& options, std::size_t curves) {
  SmoothingOptions own = options;
  for (std::size_t c = 0; c < curves; ++c) {
    if (!FairLadder::rung_of(options, c)) continue;
    if (options.per_curve.empty()) {
      own.tau = kOrigin;
    } else {
      own.per_curve[c].tau = kOrigin;
    }
  }
  return own;
}

}  // namespace

Straightened FairLadder::straightened(CorridorSolver& solver, const SmoothingOptions& options,
                                      const Progress& progress) {
  using Walls = CorridorSolver::Walls;
  std::vector<Walls> walls;
  for (std::size_t c = 0; c < solver.valleys().size(); ++c) {
    walls.push_back(rung_of(options, c) ? Walls::kRough : Walls::kExact);
  }
  const std::size_t curves = solver.drawing().drawing().curves().size();
  Straightened straight = solver.straighten(straightening(options, curves), walls, progress);
  solver.reset_lost_curves(options, straight);
  return straight;
}

void FairLadder::clear() {
  rungs_.clear();
  straight_.reset();
}

const FairLadder::Rung& FairLadder::rung(std::size_t number, const Taus& taus,
                                         CorridorSolver& solver, const TautCurves& taut,
                                         const Progress& progress) {
  const auto known = rungs_[number].find(taus);
  if (known != rungs_[number].end()) return known->second;
  const FairGroup& group = groups_[number];
  Taus next = taus;
  for (double& tau : next) {
    if (tau != kOrigin) tau = tau > kOrigin ? tau / 2 : 2 * tau;
  }
  Rung rung;
  if (next == taus) {
    rung.chain = solver.fair_from(group, taus, taut, progress);
  } else {
    const Rung& towards = this->rung(number, next, solver, taut, progress);
    if (towards.chain) {
      rung.chain = solver.fair_from(group, taus, *towards.start(), rung.trail, progress);
      if (rung.chain) rung.onward = solver.resampled(group, taus, *rung.chain, progress);
      if (rung.onward && !solver.keeps_within_walls(group, taus, *rung.chain, progress)) {
        rung.chain.swap(rung.onward);
        rung.onward.reset();
        rung.trail.clear();
      }
    }
  }
  return rungs_[number].emplace(taus, std::move(rung)).first->second;
}

/// The chain of a group for the tau values of the options, interpolated between two rungs.
std::optional<SampleChain> FairLadder::chain(std::size_t number, const SmoothingOptions& options,
                                             CorridorSolver& solver, const TautCurves& taut,
                                             const Progress& progress) {
  const FairGroup& group = groups_[number];
  Taus taus, from, to;
  for (const JoinedCurves::Part& part : group.joined.parts) {
    const double tau = options.tau_of(part.curve), rung = *rung_of(options, part.curve);
    taus.push_back(std::min(tau, kMostRung));
    from.push_back(rung);
    to.push_back(rung >= kOrigin && tau >= kOrigin ? 2 * rung : rung / 2);
  }
  const Rung& start = rung(number, from, solver, taut, progress);
  if (taus == from) return start.chain;
  const Rung& stop = rung(number, to, solver, taut, progress);
  if (!start.chain || !stop.chain) return std::nullopt;
  return solver.between(group, {from, *start.start()}, {to, *stop.chain}, stop.trail, taus,
                        progress);
}

void FairLadder::keep_for(const CorridorSolver& solver, const SmoothingOptions& options) {
  const std::size_t curves = solver.drawing().drawing().curves().size();
  Setting setting{solver.valleys(), {}, {}, solver.drawing().length_floor(options)};
  const SmoothingOptions own = straightening(options, curves);
  for (std::size_t c = 0; c < curves; ++c) setting.taus.push_back(own.tau_of(c));
  groups_ = solver.groups(options);
  for (const FairGroup& group : groups_) setting.groups.push_back(group.joined);
  if (!(setting_ == setting)) clear();
  setting_ = std::move(setting);
  rungs_.resize(groups_.size());
}

DomainResult FairLadder::smooth(CorridorSolver& solver, const SmoothingOptions& options,
                                const Progress& progress) {
  const bool whole = options.prepare_whole_mesh;  // its report has other counts
  if (whole) clear();
  keep_for(solver, options);
  StageTimes times;
  bool asked = false;
  const TautCurves taut = [&]() -> const Straightened& {
    asked = true;
    if (!straight_) {
      straight_ = straightened(solver, options, progress);
      times = straight_->time_ms;
    }
    return *straight_;
  };
  if (whole) taut();
  const Stopwatch watch;
  FairChains chains;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto& parts = groups_[g].joined.parts;
    const auto has_rung = [&](const auto& part) {
      return rung_of(options, part.curve).has_value();
    };
    if (std::all_of(parts.begin(), parts.end(), has_rung)) {
      chains.push_back(chain(g, options, solver, taut, progress));
    } else if (CorridorSolver::is_faired(options, parts.front().curve)) {
      chains.push_back(solver.fair_from(groups_[g], taus_of(groups_[g], options), taut, progress));
    } else {
      chains.emplace_back();
    }
  }
  DomainResult result;
  result.curves.resize(solver.drawing().drawing().curves().size());
  FairFinishing(solver, options, taut, progress).run(groups_, chains, result.curves);
  if (asked) report_straightening(*straight_, result);
  result.time_ms = times;
  result.time_ms.fair = std::max(0.0, watch.ms() - times.straighten - times.trace);
  if (whole || has_ended_early(progress)) clear();
  return result;
}

}  // namespace talweg

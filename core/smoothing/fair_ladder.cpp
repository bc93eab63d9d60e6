#include "talweg/core/smoothing/fair_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr double kOrigin = 1, kMostRung = 64;

}  // namespace

std::optional<double> FairLadder::rung_of(const SmoothingOptions& options, std::size_t curve) {
  const double tau = options.tau_of(curve);
  const bool plain = options.finish_of(curve) == Finish::kFair && !options.max_iterations &&
                     options.min_relative_length == 0 && options.relax_rounds == 0;
  // Below this tau each result is straightened on its own, and may lead far from the drawing.
  if (!plain || !(tau >= kLeastHeldTau)) return std::nullopt;
  const double power = std::log2(std::min(tau, kMostRung));
  return std::exp2(tau >= kOrigin ? std::floor(power) : std::ceil(power));
}

namespace {

/// The options with which the curves are straightened. While dragging there is one curve, and
/// there may be more valleys.
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

Straightened FairLadder::straightened(CorridorHold& hold, const SmoothingOptions& options,
                                      const Progress& progress) {
  using Walls = CorridorHold::Walls;
  std::vector<Walls> walls;
  for (std::size_t c = 0; c < hold.valleys().size(); ++c) {
    walls.push_back(rung_of(options, c) ? Walls::kRough : Walls::kExact);
  }
  const std::size_t curves = hold.drawing().drawing().curves().size();
  Straightened straight = hold.straighten(straightening(options, curves), walls, progress);
  hold.hold_thin_loops(options, straight);
  return straight;
}

void FairLadder::clear() {
  rungs_.clear();
  straight_.reset();
}

const FairLadder::Rung& FairLadder::rung(std::size_t curve, double tau, CorridorHold& hold,
                                         const Progress& progress) {
  const auto known = rungs_[curve].find(tau);
  if (known != rungs_[curve].end()) return known->second;
  Rung rung;
  if (tau == kOrigin) {
    rung.chain = hold.fair_from(curve, tau, straight_->curves[curve], progress);
  } else {
    const Rung& towards = this->rung(curve, tau > kOrigin ? tau / 2 : 2 * tau, hold, progress);
    if (towards.chain) {
      rung.chain = hold.fair_from(curve, tau, *towards.chain, rung.trail, progress);
    }
  }
  return rungs_[curve].emplace(tau, std::move(rung)).first->second;
}

/// A curve's chain for its tau.
std::optional<SampleChain> FairLadder::chain(std::size_t curve, const SmoothingOptions& options,
                                             CorridorHold& hold, const Progress& progress) {
  const double tau = options.tau_of(curve), from = *rung_of(options, curve);
  const Rung& start = rung(curve, from, hold, progress);
  if (tau == from || tau > kMostRung) return start.chain;
  const double to = from >= kOrigin && tau >= kOrigin ? 2 * from : from / 2;
  const Rung& stop = rung(curve, to, hold, progress);
  if (!start.chain || !stop.chain) return std::nullopt;
  return hold.between(curve, {from, *start.chain}, {to, *stop.chain}, stop.trail, tau, progress);
}

void FairLadder::keep_for(const CorridorHold& hold, const SmoothingOptions& options) {
  const std::size_t curves = hold.drawing().drawing().curves().size();
  Setting setting{hold.valleys(), {}, hold.drawing().length_floor(options)};
  const SmoothingOptions own = straightening(options, curves);
  for (std::size_t c = 0; c < curves; ++c) setting.taus.push_back(own.tau_of(c));
  if (!(setting_ == setting)) clear();
  setting_ = std::move(setting);
  rungs_.resize(curves);
}

Smoothed FairLadder::smooth(CorridorHold& hold, const SmoothingOptions& options,
                            const Progress& progress) {
  const bool whole = options.prepare_whole_mesh;  // its report differs
  if (whole) clear();
  keep_for(hold, options);
  StageTimes times;
  if (!straight_) {
    straight_ = straightened(hold, options, progress);
    times = straight_->time_ms;
  }
  const Stopwatch watch;
  FairChains chains;
  for (std::size_t c = 0; c < rungs_.size(); ++c) {
    if (rung_of(options, c)) {
      chains.push_back(chain(c, options, hold, progress));
    } else if (CorridorHold::is_faired(options, c)) {
      chains.push_back(hold.fair_from(c, options.tau_of(c), straight_->curves[c], progress));
    } else {
      chains.emplace_back();
    }
  }
  Smoothed result = smoothed_from(*straight_);
  hold.finish(options, chains, result.curves, progress);
  result.time_ms = times;
  result.time_ms.fair = watch.ms();
  if (whole) clear();
  return result;
}

}  // namespace talweg

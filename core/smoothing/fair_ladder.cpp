#include "talweg/core/smoothing/fair_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr double kOrigin = 1, kMostRung = 64;

}  // namespace

std::optional<double> FairLadder::rung_of(const SmoothingOptions& options) {
  const double tau = options.tau;
  const bool plain = options.finish == Finish::kFair && !options.max_iterations &&
                     options.min_relative_length == 0 && options.relax_rounds == 0;
  // Below this tau each result is straightened on its own, and may lead far from the drawing.
  if (!plain || !(tau >= kLeastHeldTau)) return std::nullopt;
  const double power = std::log2(std::min(tau, kMostRung));
  return std::exp2(tau >= kOrigin ? std::floor(power) : std::ceil(power));
}

Straightened FairLadder::straightened(CorridorHold& hold, const SmoothingOptions& options,
                                      const Progress& progress) {
  SmoothingOptions own = options;
  own.tau = kOrigin;
  Straightened straight = hold.straighten(own, CorridorHold::Walls::kRough, progress);
  hold.hold_thin_loops(straight);
  return straight;
}

const FairLadder::Rung& FairLadder::rung(double tau, CorridorHold& hold,
                                         const SmoothingOptions& options, StageTimes& times,
                                         const Progress& progress) {
  const auto known = rungs_.find(tau);
  if (known != rungs_.end()) return known->second;
  Rung rung;
  if (tau == kOrigin) {
    straight_ = straightened(hold, options, progress);
    times.straighten = straight_.time_ms.straighten;
    times.trace = straight_.time_ms.trace;
    const Stopwatch watch;
    rung.chains = hold.fair_from(tau, straight_, progress);
    times.fair += watch.ms();
  } else {
    const Rung& towards =
        this->rung(tau > kOrigin ? tau / 2 : 2 * tau, hold, options, times, progress);
    const Stopwatch watch;
    rung.chains = hold.fair_from(tau, towards.chains, rung.trails, progress);
    times.fair += watch.ms();
  }
  return rungs_.emplace(tau, std::move(rung)).first->second;
}

FairChains FairLadder::between(double from, double to, double tau, CorridorHold& hold,
                               const Progress& progress) const {
  const Rung &start = rungs_.at(from), &stop = rungs_.at(to);
  FairChains chains;
  for (std::size_t c = 0; c < start.chains.size(); ++c) {
    chains.emplace_back();
    if (!start.chains[c] || !stop.chains[c]) continue;
    chains.back() = hold.between(c, {from, *start.chains[c]}, {to, *stop.chains[c]}, stop.trails[c],
                                 tau, progress);
  }
  return chains;
}

void FairLadder::keep_for(const CorridorHold& hold, const SmoothingOptions& options) {
  const double floor = hold.drawing().length_floor(options);
  if (valleys_ != hold.valleys() || floor_ != floor) rungs_.clear();
  valleys_ = hold.valleys();
  floor_ = floor;
}

Smoothed FairLadder::smooth(CorridorHold& hold, const SmoothingOptions& options,
                            const Progress& progress) {
  const bool whole = options.prepare_whole_mesh;  // its report differs
  if (whole) clear();
  keep_for(hold, options);
  StageTimes times;
  const double from = *rung_of(options);
  const double to = from >= kOrigin && options.tau >= kOrigin ? 2 * from : from / 2;
  const bool at_rung = options.tau == from || options.tau > kMostRung;
  FairChains chains = rung(from, hold, options, times, progress).chains;
  if (!at_rung) rung(to, hold, options, times, progress);
  const Stopwatch watch;
  if (!at_rung) chains = between(from, to, options.tau, hold, progress);
  Smoothed result = smoothed_from(straight_);
  hold.finish(options.tau, chains, result.curves, progress);
  times.fair += watch.ms();
  result.time_ms = times;
  if (whole) clear();
  return result;
}

}  // namespace talweg

#include "talweg/core/smoothing/corridor_anchors.hpp"

#include <cmath>
#include <utility>

#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

// Below this tau each result is straightened on its own, and may lead far from the drawing.
constexpr double kLeastAnchor = kLeastHeldTau;
constexpr double kOrigin = 4;  // of the chain of anchors that leads down
constexpr double kMostAnchor = 64;
// For anchors that only lead on to lower ones.
const PolishOptions kRough{.max_rounds = 3, .newton_steps = 4, .tolerance = 1e-5};

}  // namespace

std::optional<double> CorridorAnchors::anchor_of(const SmoothingOptions& options) {
  const double tau = options.tau;
  const bool plain = options.polish && !options.max_iterations &&
                     options.min_relative_length == 0 && options.relax_rounds == 0;
  if (!plain || !(tau >= kLeastAnchor && tau <= kMostAnchor)) return std::nullopt;
  return std::exp2(std::floor(std::log2(tau)));
}

CorridorAnchors::Anchor& CorridorAnchors::at(double tau, CorridorHold& hold,
                                             const SmoothingOptions& options, StageTimes& times,
                                             const Progress& progress) {
  const auto known = anchors_.find(tau);
  if (known != anchors_.end()) return known->second;
  Anchor anchor;
  if (tau >= kOrigin) {
    SmoothingOptions own = options;
    own.tau = tau;
    anchor.straight = hold.straighten(own, CorridorHold::Walls::kRough, progress);
    hold.hold_thin_loops(anchor.straight);
    anchor.rough = anchor.straight.curves;
    times.straighten = anchor.straight.time_ms.straighten;
    times.trace = anchor.straight.time_ms.trace;
  } else {
    const Anchor& above = at(2 * tau, hold, options, times, progress);
    anchor = {above.straight, above.rough, {}};
  }
  const Stopwatch watch;
  hold.polish(tau, anchor.rough, progress, kRough);
  times.polish += watch.ms();
  return anchors_.emplace(tau, std::move(anchor)).first->second;
}

void CorridorAnchors::keep_for(const CorridorHold& hold, const SmoothingOptions& options) {
  const double floor = hold.drawing().length_floor(options);
  if (valleys_ != hold.valleys() || floor_ != floor) anchors_.clear();
  valleys_ = hold.valleys();
  floor_ = floor;
}

Smoothed CorridorAnchors::smooth(CorridorHold& hold, const SmoothingOptions& options,
                                 const Progress& progress) {
  const double from = *anchor_of(options);
  const bool whole = options.prepare_whole_mesh;  // its report differs
  if (whole) anchors_.clear();
  keep_for(hold, options);
  StageTimes times;
  Anchor& anchor = at(from, hold, options, times, progress);
  if (anchor.polished.empty()) {
    std::vector<SurfaceCurve> polished = anchor.rough;
    const Stopwatch watch;
    hold.polish(from, polished, progress);
    anchor.polished = std::move(polished);
    times.polish += watch.ms();
  }
  Straightened result = anchor.straight;
  result.curves = anchor.polished;
  if (from != options.tau) {
    const Stopwatch watch;
    hold.polish(options.tau, result.curves, progress);
    times.polish += watch.ms();
  }
  result.time_ms = times;
  if (whole) anchors_.clear();
  return smoothed_from(std::move(result));
}

std::vector<SurfaceCurve> CorridorAnchors::rough(CorridorHold& hold,
                                                 const SmoothingOptions& options,
                                                 const Progress& progress) {
  anchors_.clear();
  StageTimes times;
  std::vector<SurfaceCurve> curves = at(*anchor_of(options), hold, options, times, progress).rough;
  anchors_.clear();
  return curves;
}

}  // namespace talweg

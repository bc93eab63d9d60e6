#include "talweg/core/fairing/curve_fairing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/fairing/chain_curve.hpp"
#include "talweg/core/fairing/curve_trace.hpp"

namespace talweg {
namespace {

constexpr int kLevels = 2, kResamplingParts = 2, kResultParts = 4, kTightenings = 4;
constexpr int kSamplings = 3;
constexpr double kEarlier = 0.95, kStiffer = 4;
constexpr double kUneven = 2, kMostSamples = 1e5;

}  // namespace

double CurveFairing::spacing(double length, int level) const {
  const double wanted = band_->least_slack() / (level == 0 ? 1 : 2);
  const double least = edge_ / (level == 0 ? 4 : 8);
  return std::max({wanted, least, length / kMostSamples});
}

std::optional<SampleChain> CurveFairing::from_curve(const CurveTrace& start, Asker& asker) {
  CurveTrace trace = start;
  std::optional<SampleChain> chain;
  for (int level = 0; level < kLevels; ++level) {
    chain = maker_.sampled(trace, spacing(trace.length, level));
    if (!chain) return chain;
    for (int sampling = 0;; ++sampling) {
      FairChain fair(maker_, *band_, options_);
      fair.run(*chain, nullptr, asker);
      const bool last = level + 1 == kLevels;
      if (last) keep_within(fair, *chain, nullptr, asker);
      const bool enough = is_even(*chain) || sampling == kSamplings;
      if (last && enough) return chain;
      const std::optional<SampleChain> divided = maker_.divided(*chain, kResamplingParts);
      if (!divided) return std::nullopt;
      trace = maker_.trace_of(*divided);
      if (enough) break;
      chain = maker_.sampled(trace, spacing(trace.length, level));
      if (!chain) return chain;
    }
  }
  return chain;
}

/// Whether no join is so much longer than the others that what lies between its samples is not
/// seen.
bool CurveFairing::is_even(const SampleChain& chain) {
  const double mean = chain.length() / static_cast<double>(chain.joins.size());
  return std::all_of(chain.joins.begin(), chain.joins.end(),
                     [&](const ChainJoin& join) { return join.length <= kUneven * mean; });
}

SampleChain CurveFairing::from_chain(SampleChain chain, SampleTrail& trail, Asker& asker) {
  FairChain fair(maker_, *band_, options_);
  fair.run(chain, &trail, asker);
  keep_within(fair, chain, &trail, asker);
  if (is_even(chain)) return chain;
  const std::optional<SampleChain> divided = maker_.divided(chain, kResamplingParts);
  auto other = divided ? from_curve(maker_.trace_of(*divided), asker) : std::nullopt;
  if (!other) return chain;
  trail.clear();
  return *std::move(other);
}

/// What is beyond a wall is drawn in by stiffer walls.
void CurveFairing::keep_within(FairChain& fair, SampleChain& chain, SampleTrail* trail,
                               Asker& asker) {
  for (int round = 0; round < kTightenings && fair.stiffen(chain); ++round) {
    fair.run(chain, trail, asker);
  }
}

bool CurveFairing::keeps_within(const SampleChain& chain) const {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i]) continue;
    const BandPlace place = band_->at(chain.samples[i], {1, 0});
    if (!(place.distance <= place.wall)) return false;
  }
  return true;
}

double CurveFairing::farthest(const SurfaceCurve& curve) const {
  double most = 0;
  const auto look = [&](const SurfacePoint& point) {
    const BandPlace place = band_->at(point);
    most = std::max(most, place.distance / place.wall);
  };
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    look(curve.points[i]);
    if (i + 1 == n && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    look(segment_between(*surface_, p, q, common_face(*surface_, p, q)).point(*surface_, 0.5));
  }
  return most;
}

/// What lies between samples may be beyond a wall where they are not: walls are then felt earlier.
std::optional<FairedCurve> CurveFairing::curve_of(SampleChain chain, Asker& asker) {
  FairOptions options = options_;
  for (int round = 0;; ++round) {
    const std::optional<SampleChain> dense = maker_.divided(chain, kResultParts);
    if (!dense) return std::nullopt;
    FairedCurve result{talweg::curve_of(*surface_, maker_, *dense, edge_)};
    result.farthest = farthest(result.curve);
    if (result.farthest <= 1 || round == kTightenings) return result;
    options.felt *= kEarlier;
    options.stiffness *= kStiffer;
    FairChain fair(maker_, *band_, options);
    fair.run(chain, nullptr, asker);
    keep_within(fair, chain, nullptr, asker);
  }
}

}  // namespace talweg

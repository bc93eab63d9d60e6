// Fair patching fairs a long chain again only where something is wrong with it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/chain_parts.hpp"
#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// What stretches start from in a round, between which part of the walls, and how many samples on
/// either side of what is bad are replaced.
struct FairPatch {
  enum class From { kDrawing, kTaut } from = From::kDrawing;
  double band = 1;
  std::size_t core = 0;
};

/// Replaces stretches of a fair chain about bad places: each is faired anew from a stretch of
/// another curve, the drawing or the taut curve, between samples of the chain that stay. For groups
/// of one curve, without legs. Refers to all that it is made from. Cost: O(n log n) for n samples
/// and points in each round, and a CurveFairing of the stretches.
class FairPatching {
 public:
  FairPatching(CorridorHold& hold, const FairGroup& group, const Taus& taus,
               const SurfaceCurve& taut, Asker& asker);

  /// With less that is bad than in the rounds before, the chain is what the next ones begin with;
  /// one without a curve is worse than others. One round after the other from another curve, or in
  /// a narrower band, with wider margins. None where the chain has fewer than 2,048 samples, a
  /// quarter of them or more would be faired anew, no stretch could be, or all rounds are over.
  /// Throws Cancelled.
  std::optional<SampleChain> next(const SampleChain& chain, std::span<const SurfacePoint> bad,
                                  bool has_curve);
  /// How many stretches have been faired from the drawing.
  [[nodiscard]] std::size_t redrawn() const { return redrawn_; }

 private:
  /// What stretches start from.
  struct Course {
    const SurfaceCurve* curve;
    NearestSegment nearest;
  };
  std::optional<SampleChain> patched_by(const FairPatch& patch);
  std::optional<SampleChain> part_from(const SampleChain& chain, ChainRange range, ChainRange core,
                                       FairPatch::From from, CurveFairing& fairing);
  [[nodiscard]] std::vector<std::size_t> bad_samples(const SampleChain& chain,
                                                     std::span<const SurfacePoint> bad) const;
  [[nodiscard]] std::optional<SurfaceCurve> start_of(const SampleChain& chain, ChainRange range,
                                                     ChainRange core, const Course& course);
  [[nodiscard]] std::size_t nearest(const Course& course, const SampleChain& chain,
                                    std::size_t sample) const;

  CorridorHold* hold_;
  const FairGroup* group_;
  const Taus* taus_;
  Asker* asker_;
  Course drawn_, taut_;
  ChainMaker maker_;
  std::size_t round_ = 0, redrawn_ = 0;
  std::optional<SampleChain> best_;  // with the fewest bad places so far
  std::vector<SurfacePoint> bad_;    // of that
  bool has_curve_ = false;           // whether that has one
};

}  // namespace talweg

// The fair ladder leads fair curves from one tau to the next, so that they follow a slider
// steadily.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/smoothing/corridor.hpp"
#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Continuation in τ. A drawing is straightened once, at tau = 1, and faired there. From there the
/// chains of samples lead on to the powers of two above and below (the rungs), one after the other.
/// Between two rungs the samples lie on the ways between theirs. The result therefore follows tau
/// without jumping between several nearly equal curves, and it does not depend on what was asked
/// for before.
class FairLadder {
 public:
  /// The rung at or next to this tau, towards 1; none where the result is straightened on its own.
  static std::optional<double> rung_of(const SmoothingOptions& options);

  /// The drawing straightened at tau = 1, as the ladder begins.
  static Straightened straightened(CorridorHold& hold, const SmoothingOptions& options,
                                   const Progress& progress);

  void clear() { rungs_.clear(); }
  /// The result for options that have a rung. Keeps the rungs as long as valleys and floor stay the
  /// same. Throws Cancelled.
  Smoothed smooth(CorridorHold& hold, const SmoothingOptions& options, const Progress& progress);

 private:
  struct Rung {
    FairChains chains;
    std::vector<SampleTrail> trails;  ///< from the next rung towards 1
  };
  const Rung& rung(double tau, CorridorHold& hold, const SmoothingOptions& options,
                   StageTimes& times, const Progress& progress);
  FairChains between(double from, double to, double tau, CorridorHold& hold,
                     const Progress& progress) const;
  void keep_for(const CorridorHold& hold, const SmoothingOptions& options);

  std::map<double, Rung> rungs_;  // by tau, for what follows
  Straightened straight_;         // at tau = 1, if there are rungs
  std::vector<Corridor::Valley> valleys_;
  double floor_ = 0;
};

}  // namespace talweg

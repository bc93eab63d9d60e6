// The fair ladder leads fair curves from one tau to the next, so that they follow a slider
// steadily.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Continuation in τ. A drawing is faired at tau = 1, and straightened there where a fair curve
/// asks for that. From there the chains of samples lead on to the powers of two above and below
/// (the rungs), one after the other, each curve's own to its own tau; joined curves go together.
/// Between two rungs the samples lie on the ways between theirs. The result therefore follows tau
/// without jumping between several nearly equal curves, and it does not depend on what was asked
/// for before. Cost: a fairing for each power of two from tau to 1.
class FairLadder {
 public:
  /// The rung at or next to a curve's tau, towards 1; none where it is straightened on its own.
  static std::optional<double> rung_of(const SmoothingOptions& options, std::size_t curve);

  /// The drawing as the ladder begins: curves that have a rung are straightened at tau = 1.
  static Straightened straightened(CorridorSolver& solver, const SmoothingOptions& options,
                                   const Progress& progress);

  void clear();
  /// The result for options that have a rung for some curve. Keeps the rungs as long as what the
  /// straightening depends on stays the same. Throws Cancelled.
  DomainResult smooth(CorridorSolver& solver, const SmoothingOptions& options,
                      const Progress& progress);

 private:
  struct Rung {
    std::optional<SampleChain> chain;
    SampleTrail trail;                  ///< from where the next rung towards 1 leads on
    std::optional<SampleChain> onward;  ///< if not the chain: where the rungs beyond begin

    [[nodiscard]] const std::optional<SampleChain>& start() const {
      return onward ? onward : chain;
    }
  };
  /// What a straightening depends on.
  struct Setting {
    std::vector<Corridor::Valley> valleys;
    Taus taus;  ///< of the curves, as they are straightened
    std::vector<JoinedCurves> groups;
    double floor = 0;

    bool operator==(const Setting&) const = default;
  };
  const Rung& rung(std::size_t number, const Taus& taus, CorridorSolver& solver,
                   const TautCurves& taut, const Progress& progress);
  std::optional<SampleChain> chain(std::size_t number, const SmoothingOptions& options,
                                   CorridorSolver& solver, const TautCurves& taut,
                                   const Progress& progress);
  void keep_for(const CorridorSolver& solver, const SmoothingOptions& options);

  std::vector<FairGroup> groups_;
  std::vector<std::map<Taus, Rung>> rungs_;  // per group, for what follows
  std::optional<Straightened> straight_;
  Setting setting_;
};

}  // namespace talweg

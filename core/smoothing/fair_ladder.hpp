// The fair ladder continues fair curves from one tau to the next, so that results follow a slider
// without jumps.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/smoothing/corridor_solver.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Continuation in τ. A drawing is faired at tau = 1. From there, chains of samples are faired at
/// the powers of two above and below (the rungs), each starting from the previous rung. Each curve
/// goes to its own tau; joined curves go together. Between two rungs, samples are interpolated on
/// the ways between the rungs' samples. The result therefore follows tau without jumping between
/// nearly equal curves, and does not depend on earlier calls. Cost: a fairing for each power of two
/// from 1 to tau.
class FairLadder {
 public:
  /// The rung at a curve's tau, or the next one towards 1; empty for a curve without continuation.
  static std::optional<double> rung_of(const SmoothingOptions& options, std::size_t curve);

  /// The straightened curves of the ladder: curves with a rung are straightened at tau = 1.
  static Straightened straightened(CorridorSolver& solver, const SmoothingOptions& options,
                                   const Progress& progress);

  void clear();
  /// The result for options with a rung for some curve. The rungs are kept for later calls with the
  /// same Setting. Throws Cancelled.
  DomainResult smooth(CorridorSolver& solver, const SmoothingOptions& options,
                      const Progress& progress);

 private:
  struct Rung {
    std::optional<SampleChain> chain;
    SampleTrail trail;                  ///< the ways of the samples from the next rung towards 1
    std::optional<SampleChain> onward;  ///< the start of the next rung, if not `chain`

    [[nodiscard]] const std::optional<SampleChain>& start() const {
      return onward ? onward : chain;
    }
  };
  /// The input on which the rungs depend.
  struct Setting {
    std::vector<Corridor::Valley> valleys;
    Taus taus;  ///< of the straightening, per curve
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
  std::vector<std::map<Taus, Rung>> rungs_;  // per group
  std::optional<Straightened> straight_;
  Setting setting_;
};

}  // namespace talweg

// The corridor keeps curves near their drawing: between its walls while fairing, by its potential
// while straightening.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Fair curves as chains of samples, one per group; empty if samples could not be joined.
using FairChains = std::vector<std::optional<SampleChain>>;

/// Gives the straightened (taut) curves, computed on the first call: most fair curves do not need
/// them.
using TautCurves = std::function<const Straightened&()>;

/// The steps of the corridor's method, each for one drawing, its valleys and one tau. Refers to the
/// constructor's arguments; the memory's distance must be set to the curves of the valleys. All
/// functions throw Cancelled. A function costs the Straightening or CurveFairing that it runs.
class CorridorSolver {
 public:
  CorridorSolver(EmbeddedDrawing& drawing, SmoothingMemory& memory,
                 const std::vector<Corridor::Valley>& valleys)
      : drawing_(&drawing), memory_(&memory), distance_(&memory.distance()), valleys_(&valleys) {}

  [[nodiscard]] const EmbeddedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return *valleys_; }

  /// Whether the distance must be exact everywhere, or only near the drawing: a wall that no curve
  /// climbs may be approximate.
  enum class Walls { kExact, kRough };
  /// Straightens the curves in the potential; `walls` has one entry per valley. Legs are
  /// straightened without a lift.
  Straightened straighten(const SmoothingOptions& options, const std::vector<Walls>& walls,
                          const Progress& progress);
  /// The curves straightened without a lift, which needs no distance; empty if the lift would
  /// change them.
  std::optional<Straightened> unlifted(const SmoothingOptions& options, const Progress& progress);
  /// Resets a curve to its drawing if it is a collapsed loop, or an open curve that straightening
  /// has shortened to less than a quarter, far from the drawing. FlipOut sees the potential at
  /// vertices only, so a loop without a vertex inside collapses for any tau. Fairing evaluates the
  /// distance everywhere, so it can start from the drawing. Applies to curves with is_faired()
  /// only.
  void reset_lost_curves(const SmoothingOptions& options, Straightened& straight) const;
  /// Whether a curve is faired: its finish is kFair and tau > 0.
  [[nodiscard]] static bool is_faired(const SmoothingOptions& options, std::size_t curve) {
    return options.finish_of(curve) == Finish::kFair && options.tau_of(curve) > 0;
  }
  /// All curves in groups; two faired curves that meet are in one group.
  [[nodiscard]] std::vector<FairGroup> groups(const SmoothingOptions& options) const;
  /// A fair chain from the drawing; for tau < kLeastHeldTau first from the straightened curves, if
  /// the result is between the walls. Empty if the group has legs.
  std::optional<SampleChain> fair_from(const FairGroup& group, const Taus& taus,
                                       const TautCurves& taut, const Progress& progress);
  /// A fair chain that starts from the chain of another tau; `trail` receives the ways of the
  /// samples. Empty if the chain grows to about eight times the length of the drawing.
  std::optional<SampleChain> fair_from(const FairGroup& group, const Taus& taus,
                                       const SampleChain& chain, SampleTrail& trail,
                                       const Progress& progress);
  /// Whether the curve of a chain is between the walls.
  bool keeps_within_walls(const FairGroup& group, const Taus& taus, const SampleChain& chain,
                          const Progress& progress);
  /// The chain with new samples, if the samples are too uneven for the continuation to another tau;
  /// else empty.
  std::optional<SampleChain> resampled(const FairGroup& group, const Taus& taus,
                                       const SampleChain& chain, const Progress& progress);
  /// A chain, and the tau values of its curves.
  struct AtTaus {
    const Taus& taus;
    const SampleChain& chain;
  };
  /// The chain of a group for a tau between those of two chains. Its samples lie on the ways
  /// between the samples of both, at the same fraction as the walls; if this chain leaves the band,
  /// its samples move towards the chain with the nearer walls.
  std::optional<SampleChain> between(const FairGroup& group, const AtTaus& from, const AtTaus& to,
                                     const SampleTrail& trail, const Taus& taus,
                                     const Progress& progress);
  /// A fair curve near the first drawn curve, starting from `curve`; its ends and the points
  /// `fixed` stay. Empty if samples cannot be joined.
  std::optional<SurfaceCurve> fair(double tau, const SurfaceCurve& curve,
                                   std::span<const SurfacePoint> fixed, const Progress& progress);

  /// Calls use() with the fairing of a group, whose walls are at the fraction `narrower` of their
  /// distance.
  void with_fairing(const FairGroup& group, const Taus& taus, double narrower,
                    const LegTension& legs, ProgressPoller& poller,
                    const std::function<void(CurveFairing&)>& use);
  /// The trace of a start curve of a group; without `curve`, the trace of its drawing, marked as
  /// drawn.
  [[nodiscard]] CurveTrace traced(const FairGroup& group, const SurfaceCurve& curve) const;
  [[nodiscard]] CurveTrace traced(const FairGroup& group) const;
  /// The largest distance of the walls of a group, mesh units.
  [[nodiscard]] double largest_wall(const FairGroup& group, const Taus& taus) const;
  /// Whether a curve's band is too narrow for fairing.
  [[nodiscard]] bool is_narrow(std::size_t curve) const;
  /// The result for a curve with is_narrow(): the taut curve or the drawing.
  [[nodiscard]] const SurfaceCurve& in_narrow_band(double tau, std::size_t curve,
                                                   const SurfaceCurve& taut,
                                                   ProgressPoller& poller);

 private:
  [[nodiscard]] bool has_lost_all(const SmoothingOptions& options, const Straightened& straight,
                                  std::size_t curve) const;
  [[nodiscard]] Corridor corridor(const SmoothingOptions& options) const;
  [[nodiscard]] double exact_for_walls() const;
  [[nodiscard]] BandWidth width_of(std::size_t curve, double tau, double narrower) const;
  Straightened straighten_lifted(const SmoothingOptions& options, const std::vector<Walls>& walls,
                                 const Progress& progress);
  [[nodiscard]] CurveTrace traced(const SurfaceCurve& curve,
                                  std::span<const SurfacePoint> fixed) const;
  Straightened straighten_flat(const SmoothingOptions& options, const Progress& progress);
  [[nodiscard]] bool is_felt(const Corridor& corridor, const Straightened& flat,
                             const Progress& progress) const;

  EmbeddedDrawing* drawing_;
  SmoothingMemory* memory_;
  PolylineDistance* distance_;
  const std::vector<Corridor::Valley>* valleys_;
};

}  // namespace talweg

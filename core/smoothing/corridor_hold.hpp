// The corridor solver fairs curves between the corridor's walls, or straightens them in its
// potential.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/curve_fairing.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Fair curves as samples, one for each group; none where samples could not be joined.
using FairChains = std::vector<std::optional<SampleChain>>;

/// The straightened curves, which are computed when they are first asked for: most fair curves need
/// none.
using TautCurves = std::function<const Straightened&()>;

/// Holds a drawing in its valleys and runs one step of the method at a time, for one tau. Refers to
/// the objects it is made from; the memory's distance is set to the curves of the valleys. All
/// functions throw Cancelled. Each costs what it runs, a Straightening or a CurveFairing.
class CorridorSolver {
 public:
  CorridorSolver(EmbeddedDrawing& drawing, SmoothingMemory& memory,
                 const std::vector<Corridor::Valley>& valleys)
      : drawing_(&drawing), memory_(&memory), distance_(&memory.distance()), valleys_(&valleys) {}

  [[nodiscard]] const EmbeddedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return *valleys_; }

  /// Whether the distance must be exact everywhere, or only where valleys are narrow: a wall
  /// farther out that no curve climbs may be approximate.
  enum class Walls { kExact, kRough };
  /// With the walls of each valley. Legs are straightened without a lift.
  Straightened straighten(const SmoothingOptions& options, const std::vector<Walls>& walls,
                          const Progress& progress);
  /// The curves straightened without a lift, which needs no distance; none if the lift would change
  /// them.
  std::optional<Straightened> unlifted(const SmoothingOptions& options, const Progress& progress);
  /// Resets open curves of which straightening has left less than a quarter, far from the drawing,
  /// and loops that collapsed because no vertex lies inside them, to their drawing. FlipOut sees
  /// the potential at the mesh's vertices only, so it collapses these loops whatever tau is.
  /// Fairing measures the distance everywhere, so it starts from the drawing instead. Only for
  /// curves that are faired().
  void reset_lost_curves(const SmoothingOptions& options, Straightened& straight) const;
  /// Whether a curve is to be fair and is not straight anyway.
  [[nodiscard]] static bool is_faired(const SmoothingOptions& options, std::size_t curve) {
    return options.finish_of(curve) == Finish::kFair && options.tau_of(curve) > 0;
  }
  /// All curves, joined where two that are faired meet.
  [[nodiscard]] std::vector<FairGroup> groups(const SmoothingOptions& options) const;
  /// A fair chain that starts from the drawing; where walls are too far away to hold it, from the
  /// straightened curves if that keeps within them. None where there are legs, to which no rung
  /// leads.
  std::optional<SampleChain> fair_from(const FairGroup& group, const Taus& taus,
                                       const TautCurves& taut, const Progress& progress);
  /// A fair chain that starts from that of another tau, and the ways of its samples; none where it
  /// has become eight times as long as what was drawn.
  std::optional<SampleChain> fair_from(const FairGroup& group, const Taus& taus,
                                       const SampleChain& chain, SampleTrail& trail,
                                       const Progress& progress);
  /// Whether the curve of a chain is between its walls.
  bool keeps_within_walls(const FairGroup& group, const Taus& taus, const SampleChain& chain,
                          const Progress& progress);
  /// The chain sampled anew if its samples are too uneven to lead on to another tau.
  std::optional<SampleChain> resampled(const FairGroup& group, const Taus& taus,
                                       const SampleChain& chain, const Progress& progress);
  /// A chain for some tau that leads to one for another.
  struct AtTaus {
    const Taus& taus;
    const SampleChain& chain;
  };
  /// The chain of a group for a tau between those of two chains: its samples lie on the ways
  /// between theirs, as far as the walls are between theirs, and farther towards the nearer walls
  /// where the band would be left otherwise.
  std::optional<SampleChain> between(const FairGroup& group, const AtTaus& from, const AtTaus& to,
                                     const SampleTrail& trail, const Taus& taus,
                                     const Progress& progress);
  /// A fair curve near the first drawn one; these points of it and its ends stay. None where
  /// samples cannot be joined.
  std::optional<SurfaceCurve> fair(double tau, const SurfaceCurve& curve,
                                   std::span<const SurfacePoint> fixed, const Progress& progress);

  /// Calls use() with the fairing of a group, between walls at this part of their distance.
  void with_fairing(const FairGroup& group, const Taus& taus, double narrower,
                    const LegTension& legs, ProgressPoller& poller,
                    const std::function<void(CurveFairing&)>& use);
  /// The trace of a curve of a group from which fairing starts; that of its drawing knows it.
  [[nodiscard]] CurveTrace traced(const FairGroup& group, const SurfaceCurve& curve) const;
  [[nodiscard]] CurveTrace traced(const FairGroup& group) const;
  /// The largest distance of the walls of a group, mesh units.
  [[nodiscard]] double largest_wall(const FairGroup& group, const Taus& taus) const;
  /// Whether the curve's band is too narrow to be faired in.
  [[nodiscard]] bool is_narrow(std::size_t curve) const;
  /// What a curve becomes that is_narrow(): the taut curve or the drawing.
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

// Fairing spreads the turning of a curve evenly, between the walls of its drawing.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/core/fairing/chain_parts.hpp"
#include "talweg/core/fairing/curve_trace.hpp"
#include "talweg/core/fairing/drawn_band.hpp"
#include "talweg/core/fairing/fair_chain.hpp"
#include "talweg/core/fairing/leg_tension.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/fairing/strip_curvature.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct FairedCurve {
  SurfaceCurve curve;
  SampleChain chain;    ///< the chain from which the curve was made
  double farthest = 0;  ///< largest distance to the drawing, relative to the wall there
};

/// Fairs a curve in the band of its drawing, and legs by their tension. The spacing of samples is
/// four slacks at first, then two, one and half a slack (on a leg, a sixth and a twelfth of its
/// length), but at least an eighth of an edge. Where the drawing is wound tightly, samples are
/// closer, down to a sixteenth of an edge. The spacing grows where a chain would have more than
/// 100,000 samples. All functions throw Cancelled. Cost: a few runs of FairChain on each level.
class CurveFairing {
 public:
  /// `edge`: mean edge near the curve, mesh units. The band may be null where every stretch is a
  /// leg.
  CurveFairing(StripCurvature& curvature, const DrawnBand* band, double edge, FairOptions options,
               LegTension legs = {})
      : surface_(&curvature.surface()),
        curvature_(&curvature),
        maker_(curvature.surface()),
        band_(band),
        edge_(edge),
        options_(options),
        legs_(std::move(legs)) {}

  /// Whether a curve of this length (mesh units) would have more than 100,000 samples at the
  /// spacing that its slack and the mesh ask for. The spacing is then larger.
  [[nodiscard]] bool is_too_long(double length) const;
  /// The least spacing of samples on strokes of a curve of this length; mesh units.
  [[nodiscard]] double least_spacing(double length) const;
  /// Sets the length (mesh units) beyond which a chain is given up: such a chain winds to and fro
  /// between walls, or has left them, and would only become longer.
  void give_up_beyond(double length) { most_length_ = length; }
  /// Whether a chain was given up because it passes too many faces; other chains in this band
  /// would, too.
  [[nodiscard]] bool passes_too_many_faces() const { return passes_too_many_faces_; }
  /// A fair chain that starts from a curve; none where samples cannot be joined, or the chain is
  /// given up.
  std::optional<SampleChain> from_curve(const CurveTrace& start, ProgressPoller& poller);
  /// A fair chain that starts from a chain of another band; none if the chain is given up. The ways
  /// of its samples are appended to the trail.
  std::optional<SampleChain> from_chain(SampleChain chain, SampleTrail& trail,
                                        ProgressPoller& poller);
  /// The chain sampled again and faired, if its joins are too uneven for another start; none if
  /// they are even, or where samples cannot be joined.
  std::optional<SampleChain> resampled(const SampleChain& chain, ProgressPoller& poller);
  /// Whether no sample lies beyond a wall.
  [[nodiscard]] bool keeps_within(const SampleChain& chain) const;
  /// The largest distance of a curve to the drawing, relative to the wall there.
  [[nodiscard]] double farthest(const SurfaceCurve& curve) const;
  /// The curve of a chain that is fair or nearly so. The chain is faired again if its curve is
  /// beyond a wall. None where a sample is beyond a wall, or samples cannot be joined.
  std::optional<FairedCurve> curve_of(SampleChain chain, ProgressPoller& poller);

 private:
  [[nodiscard]] int levels() const;
  [[nodiscard]] double coarser(int level) const;
  [[nodiscard]] double wanted(double slack, double stretch, int level) const;
  [[nodiscard]] bool is_even(const SampleChain& chain, int level) const;
  [[nodiscard]] static std::vector<int> result_parts(const SampleChain& chain);
  [[nodiscard]] std::vector<double> spacings(const CurveTrace& trace, int level) const;
  std::optional<SampleChain> sampled(const CurveTrace& trace, int level);
  std::optional<CurveTrace> traced(const SampleChain& chain);
  std::optional<SampleChain> from_level(int first, const CurveTrace& start, ProgressPoller& poller);
  [[nodiscard]] double reach_of_corner(std::size_t leg) const;
  [[nodiscard]] FairChain chain_fairing(const FairOptions& options);
  void hold_swings(FairChain& fair, SampleChain& chain, const CurveTrace& legs,
                   ProgressPoller& poller);
  std::optional<SampleChain> with_freed(SampleChain chain, ProgressPoller& poller);
  [[nodiscard]] bool is_held(const SampleChain& chain, std::size_t i) const;
  [[nodiscard]] double farthest(const SampleChain& chain) const;
  [[nodiscard]] double in_walls(const SurfacePoint& point) const;
  template <class Look>
  void look_along(const SurfaceCurve& curve, const Look& look) const;
  void keep_within(FairChain& fair, SampleChain& chain, SampleTrail* trail, ProgressPoller& poller);
  std::optional<SampleChain> part_of_chain(const SampleChain& chain, ChainRange range);
  bool draw_in(const SampleChain& dense, const std::vector<int>& joins, SampleChain& chain,
               ProgressPoller& poller);
  bool keep_parts_within(const std::vector<std::size_t>& samples, FairOptions options,
                         SampleChain& chain, ProgressPoller& poller);

  const Surface* surface_;
  StripCurvature* curvature_;
  ChainMaker maker_;
  const DrawnBand* band_;
  double edge_;
  FairOptions options_;
  LegTension legs_;
  double tension_ = 0;  // of the legs, in the last run; 1 / mesh units²
  double most_length_ = HUGE_VAL;
  bool passes_too_many_faces_ = false;
};

}  // namespace talweg

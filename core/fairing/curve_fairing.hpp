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
  SampleChain chain;    ///< its own: that it was made from, faired on
  double farthest = 0;  ///< largest distance to the drawing, in distances of the wall there
};

/// Fairs a curve in the band of its drawing, and on legs by their tension. Samples are four slacks
/// apart at first, then two, one and half of one (on a leg, a sixth and a twelfth of its length),
/// nearer where the drawing is wound more tightly, but never nearer than an eighth of an edge, or a
/// sixteenth there, nor more than 100,000. All functions throw Cancelled.
/// Cost: a few runs of FairChain on each level.
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

  /// Whether a curve of this length (mesh units) has more than 100,000 samples at the distance that
  /// its slack and the mesh ask for, so that they are taken farther apart.
  [[nodiscard]] bool is_too_long(double length) const;
  /// The least distance of samples on strokes of a curve of this length; mesh units.
  [[nodiscard]] double least_spacing(double length) const;
  /// From this length on (mesh units) a chain is lost: it winds to and fro between walls, or has
  /// left them, and would only become longer.
  void give_up_beyond(double length) { most_length_ = length; }
  /// Whether a chain was lost because it passes too many faces, as others in this band would.
  [[nodiscard]] bool is_lost() const { return lost_; }
  /// A fair chain that starts from a curve; none where samples cannot be joined, or it is lost.
  std::optional<SampleChain> from_curve(const CurveTrace& start, Asker& asker);
  /// A fair chain that starts from one of another band; none where it is lost. The ways of its
  /// samples are added to the trail.
  std::optional<SampleChain> from_chain(SampleChain chain, SampleTrail& trail, Asker& asker);
  /// The chain sampled anew, and faired, if its joins have become too uneven to start from.
  std::optional<SampleChain> evened(const SampleChain& chain, Asker& asker);
  /// Whether no sample lies beyond a wall.
  [[nodiscard]] bool keeps_within(const SampleChain& chain) const;
  /// The largest distance of a curve to the drawing, in distances of the wall there.
  [[nodiscard]] double farthest(const SurfaceCurve& curve) const;
  /// The curve of a chain that is fair or nearly so; the chain is faired on where that is beyond a
  /// wall. None where samples cannot be joined.
  std::optional<FairedCurve> curve_of(SampleChain chain, Asker& asker);

 private:
  [[nodiscard]] int levels() const;
  [[nodiscard]] double coarser(int level) const;
  [[nodiscard]] double wanted(double slack, double stretch, int level) const;
  [[nodiscard]] bool is_even(const SampleChain& chain, int level) const;
  [[nodiscard]] static std::vector<int> result_parts(const SampleChain& chain);
  [[nodiscard]] std::vector<double> spacings(const CurveTrace& trace, int level) const;
  std::optional<SampleChain> sampled(const CurveTrace& trace, int level);
  std::optional<CurveTrace> traced(const SampleChain& chain);
  std::optional<SampleChain> from_level(int first, const CurveTrace& start, Asker& asker);
  [[nodiscard]] double reach_of_corner(std::size_t leg) const;
  [[nodiscard]] FairChain chain_fairing(const FairOptions& options);
  void hold_swings(FairChain& fair, SampleChain& chain, const CurveTrace& legs, Asker& asker);
  std::optional<SampleChain> loosened(SampleChain chain, Asker& asker);
  [[nodiscard]] bool is_held(const SampleChain& chain, std::size_t i) const;
  [[nodiscard]] double farthest(const SampleChain& chain) const;
  [[nodiscard]] double in_walls(const SurfacePoint& point) const;
  template <class Look>
  void look_along(const SurfaceCurve& curve, const Look& look) const;
  void keep_within(FairChain& fair, SampleChain& chain, SampleTrail* trail, Asker& asker);
  std::optional<SampleChain> part_of_chain(const SampleChain& chain, ChainRange range);
  bool draw_in(const SampleChain& dense, const std::vector<int>& joins, SampleChain& chain,
               Asker& asker);
  bool keep_parts_within(const std::vector<std::size_t>& samples, FairOptions options,
                         SampleChain& chain, Asker& asker);

  const Surface* surface_;
  StripCurvature* curvature_;
  ChainMaker maker_;
  const DrawnBand* band_;
  double edge_;
  FairOptions options_;
  LegTension legs_;
  double tension_ = 0;  // of the legs at last, 1 / mesh units²
  double most_length_ = HUGE_VAL;
  bool lost_ = false;
};

}  // namespace talweg

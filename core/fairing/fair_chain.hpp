// A fair chain bends as little as it can between the walls of its drawing.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "talweg/core/fairing/band_solver.hpp"
#include "talweg/core/fairing/drawn_band.hpp"
#include "talweg/core/fairing/leg_tension.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/fairing/strip_curvature.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct FairOptions {
  double centering = 1e-3;  ///< β
  double stiffness = 10;    ///< ρ, of the walls
  double felt = 0.8;  ///< distance W at which a wall is felt, relative to the distance of the wall
  double tolerance = 3e-3;      ///< relative gain in energy below which the run ends
  double leg_tolerance = 1e-4;  ///< the same for a chain with legs
  int max_iterations = 60;
  std::optional<double> mean;  ///< κ₀ of the whole chain, for a part of a chain; 1 / mesh units
};

/// Minimises E = Σ wᵢ (θᵢ / wᵢ − κ₀)² + β Σ wᵢ δᵢ² / εᵢ⁴ + ρ Σ wᵢ max(0, δᵢ − Wᵢ)² / εᵢ⁴ over the
/// samples of a chain by the Gauss-Newton method. θᵢ is the turn at sample i, wᵢ half the length
/// of its two joins, δᵢ its distance to the drawing, εᵢ the slack and Wᵢ the distance of the felt
/// walls there. κ₀ is the mean curvature of a loop, and 0 for an open chain and for a loop with
/// corners. Turns at corners cost nothing. Legs have no drawing: their tension, t · length,
/// replaces the terms with δ. Where places on the drawing are known, the samples that a step would
/// lead out of the walls, or into the part of the band that belongs to another strand, are held,
/// and the step is solved again, up to six times; the last step may lead samples out.
/// docs/development/algorithm.md describes the method. Cost of an iteration: samples + the faces
/// that joins and steps pass, and a DrawnBand::at() for each sample that moves. A run ends after 60
/// iterations, or 1,000 such faces for each sample.
class FairChain {
 public:
  /// The band may be null where every stretch is a leg.
  FairChain(ChainMaker& maker, const DrawnBand* band, StripCurvature& curvature,
            const FairOptions& options)
      : maker_(&maker), band_(band), options_(options), curvature_(&curvature) {}

  /// Refers to the tension. `reach`: per sample, the largest offset of a freed sample, mesh units;
  /// freed samples stay if `reach` is empty.
  void set_legs(const LegTension& tension, std::vector<double> reach = {}) {
    legs_ = &tension;
    reach_ = std::move(reach);
  }

  /// Makes steps until the energy hardly falls. The chain keeps its number of samples. The ways of
  /// the samples are appended to the trail, unless it is null. Ends early, after a whole step or
  /// before the first, when the poller's budget is used up. Throws Cancelled.
  void run(SampleChain& chain, SampleTrail* trail, ProgressPoller& poller);
  /// Makes the walls stiffer where samples of the chain are beyond the band's walls after run(), or
  /// almost; true if there are such samples.
  bool stiffen(const SampleChain& chain);
  /// The samples beyond the band's walls after run(), or almost, ascending.
  [[nodiscard]] std::vector<std::size_t> near_walls(const SampleChain& chain) const;
  [[nodiscard]] const FairOptions& options() const { return options_; }
  /// Whether the last run ended because the chain passes too many faces: in a fan of needles around
  /// a distant vertex, each step passes thousands of faces.
  [[nodiscard]] bool passes_too_many_faces() const { return passes_too_many_faces_; }
  /// κ₀ of a chain without legs, 1 / mesh units.
  [[nodiscard]] static double mean_curvature(const SampleChain& chain);
  /// Per sample: the sum of its steps to the left, mesh units.
  [[nodiscard]] const std::vector<double>& offsets() const { return offsets_; }
  /// The tension t of the legs with a LegTension::factor() of 1, 1 / mesh units².
  [[nodiscard]] double tension() const { return tension_; }

 private:
  struct Row {
    double before = 0, here = 0, after = 0, rest = 0;  ///< κ − κ₀, linear in the steps
    double weight = 0;                                 ///< wᵢ
  };
  [[nodiscard]] bool has_legs() const { return legs_ != nullptr; }
  [[nodiscard]] static bool is_freed(const SampleChain& chain, std::size_t i) {
    return !chain.freed.empty() && chain.freed[i];
  }
  [[nodiscard]] bool is_on_leg(const SampleChain& chain, std::size_t i) const;
  [[nodiscard]] double mean_of(const SampleChain& chain) const;
  [[nodiscard]] BandPlace place_of(const SampleChain& chain, std::size_t i, double offset) const;
  void measure(const SampleChain& chain, const std::vector<double>& offsets,
               const std::vector<bool>& changed, std::vector<BandPlace>& places) const;
  [[nodiscard]] double tension_energy_at(const SampleChain& chain, std::size_t i) const;
  [[nodiscard]] double bend_at(const SampleChain& chain, std::size_t join) const;
  struct LegBending {
    double bending = 0, length = 0;  ///< 1 / mesh units, mesh units
  };
  [[nodiscard]] std::vector<LegBending> bendings_of_legs(const SampleChain& chain) const;
  void balance(const SampleChain& chain);
  /// Per sample.
  void energies(const SampleChain& chain, const std::vector<BandPlace>& places,
                std::vector<double>& energies) const;
  void set_rows(const SampleChain& chain);
  void assemble(const SampleChain& chain);
  void add_tension(const SampleChain& chain);
  void add_bends(const SampleChain& chain);
  void add_walls(const SampleChain& chain, BandSystem& system) const;
  bool solve(const SampleChain& chain, bool first, std::vector<double>& left);
  void limit(const SampleChain& chain, std::vector<double>& left) const;
  [[nodiscard]] bool is_inside(const SampleChain& chain, std::size_t i,
                               const BandPlace& place) const;
  bool hold_leaving(const SampleChain& chain, const SampleChain& moved,
                    const std::vector<BandPlace>& now);
  bool hold_at_jumps(const SampleChain& chain, const SampleChain& moved,
                     const std::vector<double>& left, const std::vector<double>& now);
  bool step(SampleChain& chain, SampleTrail* trail);

  ChainMaker* maker_;
  const DrawnBand* band_;
  FairOptions options_;
  StripCurvature* curvature_;
  const LegTension* legs_ = nullptr;
  std::vector<double> reach_;
  std::vector<double> tensions_;  // per join: t; empty without legs
  double tension_ = 0;
  std::vector<double> offsets_;
  double damping_ = 1e-2;
  std::vector<BandPlace> places_;
  std::size_t passed_ = 0;  // faces, by joins and steps
  bool passes_too_many_faces_ = false;
  double energy_ = 0;             // 1 / mesh units
  std::vector<double> energies_;  // per sample
  std::vector<Row> rows_;
  BandSystem system_, with_walls_;  // of a step: without walls, with the felt walls
  std::vector<double> stiffness_;   // per sample
  /// Per sample: 1 if the wall on the sample's side of the drawing is felt, -1 for the other wall,
  /// 0 for none.
  std::vector<int> active_;
  std::vector<int> held_;  // per sample: whether the step leaves it in place
};

}  // namespace talweg

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
  double middle = 1e-3;         ///< β
  double stiffness = 10;        ///< ρ, of the walls
  double felt = 0.8;            ///< the walls that are felt, as part of the band's
  double tolerance = 3e-3;      ///< relative gain in energy below which it ends
  double leg_tolerance = 1e-4;  ///< the same for a chain with legs
  int max_iterations = 60;
  std::optional<double> mean;  ///< κ₀ of the chain that this one is a part of, 1 / mesh units
};

/// Minimises E = Σ wᵢ (θᵢ / wᵢ − κ₀)² + β Σ wᵢ δᵢ² / εᵢ⁴ + ρ Σ wᵢ max(0, δᵢ − Wᵢ)² / εᵢ⁴ over the
/// samples of a chain by Gauss and Newton's method; W is the distance of the walls that are felt,
/// κ₀ the mean curvature of a loop, 0 for an open chain and for a loop with corners, where turns
/// cost nothing. On legs there is no drawing: t · length, their tension, stands for the terms with
/// δ. Where places on the drawing are known, samples that a step would lead out of the walls, or
/// into the part of the band that belongs to another strand, are held; the step is solved again up
/// to six times, and may then lead some out. docs/algorithm.md has all of it. Cost of an iteration:
/// samples + the faces that joins and steps pass, and a DrawnBand::at() for each sample that moves.
/// It ends after 60 iterations, or 5,000 such faces for each sample.
class FairChain {
 public:
  /// The band may be null where every stretch is a leg.
  FairChain(ChainMaker& maker, const DrawnBand* band, StripCurvature& curvature,
            const FairOptions& options)
      : maker_(&maker), band_(band), options_(options), curvature_(&curvature) {}

  /// Refers to the tension. Per sample how far a loose one may move, mesh units; where that is not
  /// given, loose samples stay.
  void set_legs(const LegTension& tension, std::vector<double> reach = {}) {
    legs_ = &tension;
    reach_ = std::move(reach);
  }

  /// The chain keeps its number of samples; their ways are added to the trail, unless it is null.
  /// Ends early, after a whole step or before the first, when the asker's budget is used up. Throws
  /// Cancelled.
  void run(SampleChain& chain, SampleTrail* trail, Asker& asker);
  /// Makes the walls stiffer where samples of the chain that run() left are beyond the band's, or
  /// almost; tells whether there are any.
  bool stiffen(const SampleChain& chain);
  /// Those samples, ascending.
  [[nodiscard]] std::vector<std::size_t> near_walls(const SampleChain& chain) const;
  [[nodiscard]] const FairOptions& options() const { return options_; }
  /// Whether the last run ended because the chain winds through more faces than it is worth: around
  /// a vertex that is far away, each step passes thousands of needles.
  [[nodiscard]] bool is_lost() const { return lost_; }
  /// κ₀ of a chain without legs, 1 / mesh units.
  [[nodiscard]] static double mean_curvature(const SampleChain& chain);
  /// Per sample: how far it has moved to the left in all, mesh units.
  [[nodiscard]] const std::vector<double>& offsets() const { return offsets_; }
  /// The tension t of the legs whose own is not stronger, 1 / mesh units².
  [[nodiscard]] double tension() const { return common_pull_; }

 private:
  struct Row {
    double before = 0, here = 0, after = 0, rest = 0;  ///< of the curvature, linear in the steps
    double weight = 0;                                 ///< wᵢ
  };
  [[nodiscard]] bool has_legs() const { return legs_ != nullptr; }
  [[nodiscard]] static bool is_loose(const SampleChain& chain, std::size_t i) {
    return !chain.loose.empty() && chain.loose[i];
  }
  [[nodiscard]] bool is_on_leg(const SampleChain& chain, std::size_t i) const;
  [[nodiscard]] double mean_of(const SampleChain& chain) const;
  [[nodiscard]] BandPlace place_of(const SampleChain& chain, std::size_t i, double offset) const;
  void measure(const SampleChain& chain, const std::vector<double>& offsets,
               const std::vector<bool>& anew, std::vector<BandPlace>& places) const;
  [[nodiscard]] double pull_at(const SampleChain& chain, std::size_t i) const;
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
  void add_pull(const SampleChain& chain);
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
  std::vector<double> pull_;  // per join: t; empty without legs
  double common_pull_ = 0;
  std::vector<double> offsets_;
  double damping_ = 1e-2;
  std::vector<BandPlace> places_;
  std::size_t passed_ = 0;  // faces, by joins and steps
  bool lost_ = false;
  double energy_ = 0;             // 1 / mesh units
  std::vector<double> energies_;  // per sample
  std::vector<Row> rows_;
  BandSystem system_, with_walls_;  // of a step, without walls and with those that are felt
  std::vector<double> stiffness_;   // per sample
  std::vector<int> active_;         // per sample: whether its wall is felt; -1 across the drawing
  std::vector<int> held_;           // per sample: whether it stays
};

}  // namespace talweg

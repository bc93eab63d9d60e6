// Fair finishing makes straightened curves fair, as far as that keeps what must be kept.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Replaces straightened curves by those of their chains, one group after the other, until none
/// crosses another. Where that would leave the walls, or cross what the drawing does not cross,
/// stretches of them are faired anew (fair_patching.hpp), or the curves start from the drawing, in
/// a narrower band; of legs those that fail are drawn tighter; if nothing helps those stretches of
/// them that fail stay straightened (fair_mending.hpp), or all of them, with a warning. Curves that
/// are not faired stay too. Joined curves that fail are faired each for itself. Refers to the
/// objects it is made from. Cost: FairPatching, or up to four tries of a CurveFairing for each
/// group, and FairMending: a bad place that no stretch cures makes all of it try again; and the
/// segments of all curves in each round in which some cross.
class FairFinishing {
 public:
  FairFinishing(CorridorHold& hold, const SmoothingOptions& options, const Progress& progress)
      : hold_(&hold), options_(&options), progress_(&progress), asker_(progress, "fair") {}

  /// Once. Throws Cancelled.
  void run(const std::vector<FairGroup>& groups, const FairChains& chains,
           std::vector<SmoothedCurve>& curves);

 private:
  struct Attempt {
    FairGroup group;
    std::optional<SampleChain> chain;
    SurfaceCurve taut;
    bool redrawn = false;  ///< whether the chain has started from the drawing somewhere
    std::size_t tries = 0;
    bool patched = false;  ///< whether that has been tried
    /// Of a curve with legs: per stretch, how much tighter it is drawn since it failed.
    std::vector<double> tighter;
    std::string left_taut;  ///< a warning
  };
  void begin(const FairGroup& group, const std::optional<SampleChain>& chain);
  void warn_if_too_long(const FairGroup& group);
  [[nodiscard]] bool is_redrawn(const FairGroup& group) const;
  void count_redrawn(const FairGroup& group);
  void make_fair(std::size_t number);
  void make_fair_apart(const FairGroup& group);
  std::optional<SurfaceCurve> patched(Attempt& attempt, const Taus& taus);
  std::vector<SurfacePoint> fails_at(const Attempt& attempt, const Taus& taus, SampleChain& chain,
                                     std::optional<SurfaceCurve>& curve);
  std::vector<SurfacePoint> crossed_points(std::size_t number, const SurfaceCurve& curve);
  void set(std::size_t number, SurfaceCurve curve);
  [[nodiscard]] bool crosses_as_drawn(std::size_t curve);
  void tighten(Attempt& attempt, std::span<const SurfacePoint> at, const SurfaceCurve& curve);
  [[nodiscard]] std::vector<SurfacePoint> bends_more_at(const Attempt& attempt,
                                                        const SurfaceCurve& curve) const;
  [[nodiscard]] bool bends_more(const Attempt& attempt, const Taus& taus,
                                const SurfaceCurve& curve);
  std::optional<SurfaceCurve> mended(Attempt& attempt, const Taus& taus);
  [[nodiscard]] bool is_smooth(const Attempt& attempt, const Taus& taus);
  std::optional<SurfaceCurve> tried(Attempt& attempt, const Taus& taus);
  [[nodiscard]] bool keeps_within(const FairGroup& group, const Taus& taus,
                                  const SurfaceCurve& curve);

  CorridorHold* hold_;
  const SmoothingOptions* options_;
  const Progress* progress_;
  Asker asker_;
  std::vector<SmoothedCurve>* curves_ = nullptr;
  Straightened taut_;  // `redrawn` is of the last fairing alone
  std::vector<SurfaceCurve> now_;
  std::optional<CurvesByFace> by_face_;       // those of now_, once they are needed
  std::optional<CurvesByFace> taut_by_face_;  // the same of the taut curves
  std::vector<Attempt> attempts_;
  std::vector<std::size_t> attempt_of_;  // per curve
};

}  // namespace talweg

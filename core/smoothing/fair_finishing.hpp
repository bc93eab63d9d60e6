// Fair finishing makes fair curves of chains, checks them, and falls back to other starts or taut
// curves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/smoothing/corridor_solver.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/fair_group.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Makes curves of the groups' chains, group by group, until no curve has new crossings. If a curve
/// has a new crossing, or bends more than its start curve, the next try starts from the taut curve,
/// or from the drawing in a narrower band; for legs, the tension of the failing legs is increased.
/// If all tries fail, a curve that keeps within its walls is accepted although it bends more;
/// otherwise the curve stays taut, with a warning. Curves that are not faired are the straightened
/// curves. Joined curves that fail are faired separately. Refers to the constructor's arguments.
/// Cost: up to four tries of a CurveFairing per group; and the segments of all curves in each round
/// with crossings.
class FairFinishing {
 public:
  FairFinishing(CorridorSolver& solver, const SmoothingOptions& options, TautCurves taut,
                const Progress& progress)
      : solver_(&solver),
        options_(&options),
        taut_(std::move(taut)),
        progress_(&progress),
        poller_(progress, "fair") {}

  /// Sets the curves, and their warnings. To be called once. Throws Cancelled.
  void run(const std::vector<FairGroup>& groups, const FairChains& chains,
           std::vector<CurveResult>& curves);

 private:
  struct Taut {
    SurfaceCurve curve;
    bool is_close = false;  ///< to the drawing: a fair curve should then not bend more
  };
  struct Attempt {
    FairGroup group;
    std::optional<SampleChain> chain;
    std::optional<Taut> taut;  ///< computed on first use
    std::size_t tries = 0;
    std::optional<SurfaceCurve> bent;  ///< the first result whose only fault is its bending
    /// For a curve with legs: per stretch, the factor in its tension after failed tries.
    std::vector<double> tighter;
    std::string left_taut;  ///< a warning
  };
  void begin(const FairGroup& group, const std::optional<SampleChain>& chain);
  const Taut& taut(Attempt& attempt);
  void warn_if_too_long(const FairGroup& group);
  [[nodiscard]] bool is_close(const FairGroup& group, const Taus& taus, const SurfaceCurve& taut);
  void make_fair(std::size_t number);
  void make_fair_apart(const FairGroup& group);
  std::vector<SurfacePoint> crossed_points(std::size_t number, const SurfaceCurve& curve);
  void set(std::size_t number, SurfaceCurve curve);
  [[nodiscard]] bool crosses_as_drawn(std::size_t curve);
  void tighten(Attempt& attempt, std::span<const SurfacePoint> at, const SurfaceCurve& curve);
  [[nodiscard]] std::vector<SurfacePoint> bends_more_at(Attempt& attempt,
                                                        const SurfaceCurve& curve);
  [[nodiscard]] bool bends_more(Attempt& attempt, const SurfaceCurve& curve);
  std::optional<SurfaceCurve> faired(Attempt& attempt, const Taus& taus, const LegStart& legs);
  [[nodiscard]] bool is_straight(Attempt& attempt);
  [[nodiscard]] bool is_smooth(Attempt& attempt, const Taus& taus);
  [[nodiscard]] bool needs_no_taut(const FairGroup& group, const Taus& taus,
                                   const SurfaceCurve& curve) const;
  std::optional<SurfaceCurve> tried(Attempt& attempt, const Taus& taus);
  [[nodiscard]] bool keeps_within(const FairGroup& group, const Taus& taus,
                                  const SurfaceCurve& curve);

  CorridorSolver* solver_;
  const SmoothingOptions* options_;
  TautCurves taut_;
  const Progress* progress_;
  ProgressPoller poller_;
  std::vector<CurveResult>* curves_ = nullptr;
  std::vector<SurfaceCurve> now_;
  std::optional<CurvesByFace> by_face_;       // of now_; made on first use
  std::optional<CurvesByFace> taut_by_face_;  // of the taut curves
  std::vector<Attempt> attempts_;
  std::vector<std::size_t> attempt_of_;  // per curve
};

}  // namespace talweg

#include "talweg/core/smoothing/corridor_method.hpp"

#include <optional>
#include <utility>

#include "talweg/core/lifting/relaxation.hpp"
#include "talweg/core/smoothing/corridor_solver.hpp"
#include "talweg/core/smoothing/corridor_valleys.hpp"
#include "talweg/core/smoothing/fair_finishing.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

/// Smooths without the ladder: the result depends on this tau only.
DomainResult smooth_for_itself(CorridorSolver& solver, const SmoothingOptions& options,
                               const Progress& progress) {
  std::optional<Straightened> flat;
  const std::size_t curves = solver.drawing().drawing().curves().size();
  bool free = true;
  for (std::size_t c = 0; c < curves; ++c) free = free && options.tau_of(c) == 0;
  if (free || !solver.drawing().any_legs()) flat = solver.unlifted(options, progress);
  // A curve with tau < kLeastHeldTau, or that is not faired, may climb walls anywhere.
  const std::vector walls(solver.valleys().size(), CorridorSolver::Walls::kExact);
  Straightened straight = flat ? *flat : solver.straighten(options, walls, progress);
  Stopwatch watch;
  relax(solver.drawing().mesh(), straight.curves, {options.relax_rounds, solver.drawing().fixed()},
        progress);
  straight.time_ms.relax = watch.lap();
  // Curves without an effective lift are straight already.
  if (flat) return domain_result_from(std::move(straight));
  solver.reset_lost_curves(options, straight);
  const std::vector<FairGroup> groups = solver.groups(options);
  const TautCurves taut = [&]() -> const Straightened& { return straight; };
  FairChains chains(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!CorridorSolver::is_faired(options, groups[g].joined.parts.front().curve)) continue;
    chains[g] = solver.fair_from(groups[g], taus_of(groups[g], options), taut, progress);
  }
  DomainResult result = domain_result_from(straight);
  FairFinishing(solver, options, taut, progress).run(groups, chains, result.curves);
  result.time_ms.fair = watch.ms();
  return result;
}

}  // namespace

void CorridorMethod::set(std::span<const SurfaceCurve> near, std::vector<Corridor::Valley> valleys,
                         const Progress& progress) {
  valleys_ = std::move(valleys);
  ProgressPoller poller(progress, "solve");
  const ScopedPoller scoped(memory_->distance(), poller);
  memory_->distance().set_with_few_windows(near);
}

void CorridorMethod::solve(const Progress& progress) {
  const OrderedDrawing& drawing = drawing_->drawing();
  if (drawing_->all_legs()) {  // no stroke to measure distances from
    valleys_.assign(drawing.curves().size(), {});
    return;
  }
  set(drawing.curves(), {}, progress);
  valleys_ = valleys_of(drawing_->mesh(), drawing, progress);
}

DomainResult CorridorMethod::smooth(const SmoothingOptions& options, const Progress& progress) {
  return smooth_in(with_options(valleys_, drawing_->mesh(), drawing_->drawing(), options), options,
                   progress);
}

DomainResult CorridorMethod::smooth_in_own_valleys(const SmoothingOptions& options,
                                                   const Progress& progress) {
  return smooth_in(valleys_, options, progress);
}

DomainResult CorridorMethod::smooth_in(const std::vector<Corridor::Valley>& valleys,
                                       const SmoothingOptions& options, const Progress& progress) {
  CorridorSolver solver(*drawing_, *memory_, valleys);
  bool laddered = false;
  for (std::size_t c = 0; c < drawing_->drawing().curves().size(); ++c) {
    laddered = laddered || (FairLadder::rung_of(options, c) && !drawing_->all_legs());
  }
  DomainResult result = laddered ? ladder_.smooth(solver, options, progress)
                                 : smooth_for_itself(solver, options, progress);
  result.potential = PotentialKind::kCorridor;
  result.engine = Engine::kLocal;
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    result.curves[c].slack = largest_slack(valleys[c]);
    result.curves[c].has_legs = drawing_->legs()[c].any();
  }
  return result;
}

std::vector<SurfaceCurve> CorridorMethod::taut(const SmoothingOptions& options,
                                               const Progress& progress) {
  CorridorSolver solver(*drawing_, *memory_, valleys_);
  return FairLadder::straightened(solver, options, progress).curves;
}

std::optional<SurfaceCurve> CorridorMethod::fair(double tau, const SurfaceCurve& curve,
                                                 std::span<const SurfacePoint> fixed,
                                                 const Progress& progress) {
  return CorridorSolver(*drawing_, *memory_, valleys_).fair(tau, curve, fixed, progress);
}

}  // namespace talweg

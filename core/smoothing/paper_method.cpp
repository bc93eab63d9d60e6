#include "talweg/core/smoothing/paper_method.hpp"

#include <utility>

#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/lifting/relaxation.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

DomainResult straightened_and_relaxed(EmbeddedDrawing& drawing, const SmoothingOptions& options,
                                      SignpostTriangulation::Metric metric,
                                      const Progress& progress) {
  Straightened straight = drawing.straighten(options, std::move(metric), progress);
  const Stopwatch watch;
  relax(drawing.mesh(), straight.curves, {options.relax_rounds, drawing.fixed()}, progress);
  DomainResult result = domain_result_from(std::move(straight));
  result.time_ms.relax = watch.ms();
  return result;
}

}  // namespace

DomainResult smooth_in(EmbeddedDrawing& drawing, const GivenPotential& potential,
                       const SmoothingOptions& options, const Progress& progress) {
  const std::size_t own = drawing.surface().vertex_count(), k = potential.components;
  const std::vector<double> inserted = drawing.straightening().at_inserted(potential.values, k);
  const auto metric = [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {
      return v.index() < own ? potential.values.subspan(v.index() * k, k)
                             : std::span(inserted).subspan((v.index() - own) * k, k);
    };
    return lifted_length(length, at(p), at(q));
  };
  DomainResult result = straightened_and_relaxed(drawing, options, metric, progress);
  result.potential = PotentialKind::kCustom;
  return result;
}

void PaperMethod::need_distance(const Progress& progress) {
  if (!lift_.is_known()) lift_.solve(drawing_->capped(), drawing_->options().heat(), progress);
}

void PaperMethod::set_distance(std::vector<double> distance) {
  lift_.set(std::move(distance), drawing_->drawing().curves().size() > 1);
}

DomainResult PaperMethod::smooth(const SmoothingOptions& options, const Progress& progress) {
  if (options.tau == 0) {
    return straightened_and_relaxed(*drawing_, options, unlifted_length, progress);
  }
  need_distance(progress);
  return straightened_and_relaxed(
      *drawing_, options, lift_.metric(options.potential, options.tau, drawing_->drawn_length()),
      progress);
}

}  // namespace talweg

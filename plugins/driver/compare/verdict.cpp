#include "compare/verdict.hpp"

#include <algorithm>

namespace talweg::driver {
namespace {

bool judged(const Comparison& c, const ComparedRun& run) {
  return run.ok() && !same_method(c.methods[run.method], c.methods.front());
}

bool ties_or_wins(const ComparedRun& ours, const ComparedRun& other) {
  return ours.deviation() <= 1.02 * other.deviation() &&
         ours.numbers.curvature <=
             std::max(1.02 * other.numbers.curvature, other.numbers.curvature + 0.02);
}

}  // namespace

std::vector<std::size_t> beaten_by(const Comparison& comparison) {
  std::vector<std::size_t> beaten;
  for (std::size_t k = 0; k < comparison.runs.size(); ++k) {
    const ComparedRun& other = comparison.runs[k];
    if (!judged(comparison, other)) continue;
    const bool held =
        std::any_of(comparison.runs.begin(), comparison.runs.end(), [&](const ComparedRun& ours) {
          return ours.ok() &&
                 same_method(comparison.methods[ours.method], comparison.methods.front()) &&
                 ties_or_wins(ours, other);
        });
    if (!held) beaten.push_back(k);
  }
  return beaten;
}

std::size_t judged_runs(const Comparison& comparison) {
  return static_cast<std::size_t>(
      std::count_if(comparison.runs.begin(), comparison.runs.end(),
                    [&](const ComparedRun& run) { return judged(comparison, run); }));
}

std::vector<std::optional<double>> bounds_to_try(const Comparison& comparison) {
  std::vector<std::optional<double>> bounds;
  if (!same_method(comparison.methods.front(), bounded_method())) return bounds;
  for (const std::size_t k : beaten_by(comparison))
    bounds.emplace_back(comparison.runs[k].deviation());
  std::sort(bounds.begin(), bounds.end());
  return bounds;
}

}  // namespace talweg::driver

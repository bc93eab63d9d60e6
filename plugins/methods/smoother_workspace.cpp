#include "smoother_workspace.hpp"

#include <cstdint>

namespace talweg::plugins {

CurveSmoother& SmootherWorkspace::smoother() {
  if (!smoother_) smoother_ = std::make_unique<CurveSmoother>(opened_mesh());
  return *smoother_;
}

void SmootherWorkspace::check(const SmoothingResult& result) {
  if (result.total.termination == Outcome::kCancelled) {
    throw plugin::Services::cancelled();
  }
}

void SmootherWorkspace::add_changes(SmoothingResult& result) const {
  const std::vector<std::string>& changes = host_mesh().changes();
  for (SmoothingReport& report : result.reports) {
    report.warnings.insert(report.warnings.end(), changes.begin(), changes.end());
  }
  result.total.warnings.insert(result.total.warnings.end(), changes.begin(), changes.end());
}

void SmootherWorkspace::give_curves(const plugin::Outputs& outputs, const SmoothingResult& result,
                                    const FieldsOf& fields_of,
                                    const ReportEntriesOf& entries_of) const {
  plugins::give_curves(outputs, host_mesh(), result.curves, fields_of, [&](std::int64_t curve) {
    return entries_of(curve < 0 ? result.total : result.reports[static_cast<std::size_t>(curve)]);
  });
}

}  // namespace talweg::plugins

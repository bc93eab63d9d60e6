#include "smoother_workspace.hpp"

#include <cstdint>

namespace talweg::plugins {

CurveSmoother& SmootherWorkspace::smoother() {
  if (!smoother_) smoother_ = std::make_unique<CurveSmoother>(opened_mesh());
  return *smoother_;
}

void SmootherWorkspace::check(const SmoothingResult& result) {
  if (result.total.termination == to_string(Termination::kCancelled)) {
    throw plugin::Services::cancelled();
  }
}

void SmootherWorkspace::give_curves(const plugin::Outputs& outputs, const SmoothingResult& result,
                                    const FieldsOf& fields_of, const EntriesOf& entries_of) const {
  std::vector<PlacedCurve> placed;
  std::vector<std::vector<PointField>> fields(result.curves.size());
  for (std::size_t c = 0; outputs.wants_curves() && c < result.curves.size(); ++c) {
    placed.push_back(place(mesh(), result.curves[c], c));
    if (outputs.wants_point_fields()) fields[c] = fields_of(c);
  }
  if (outputs.wants_report()) give(outputs, -1, entries_of(result.total));
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    if (outputs.wants_curves()) give(outputs, placed[c], fields[c]);
    if (outputs.wants_report()) {
      give(outputs, static_cast<std::int64_t>(c), entries_of(result.reports[c]));
    }
  }
}

}  // namespace talweg::plugins

// An offset report has the sides, lengths and distance errors of offset curves.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/offset/offset_curves.hpp"

namespace talweg {

/// The totals: counts, length, the largest distance error, and the given warnings; for a single
/// curve also its distance and side. O(curves), like curve_entries_of().
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const OffsetResult& result,
                                    const std::vector<std::string>& warnings);
/// The report on each curve.
std::vector<std::vector<ReportEntry>> curve_entries_of(const OffsetResult& result);

/// Throws Error(kBadUsage) with the warnings of the result if it has no curve.
void check_any(const OffsetResult& result);

}  // namespace talweg

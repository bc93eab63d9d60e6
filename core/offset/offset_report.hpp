// An offset report tells what an offset's curves are, and how exactly they have their distance.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/offset/offset_curves.hpp"

namespace talweg {

/// The totals: numbers, length, the largest error, and these warnings; of a single curve also the
/// distance and side. O(curves), as the next.
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const OffsetResult& result,
                                    const std::vector<std::string>& warnings);
/// The report on each curve.
std::vector<std::vector<ReportEntry>> curve_entries_of(const OffsetResult& result);

/// Throws Error(kBadUsage) with the result's sentences if there is no curve at all.
void check_any(const OffsetResult& result);

}  // namespace talweg

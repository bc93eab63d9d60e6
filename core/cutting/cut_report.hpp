// A cut report describes a cut of a mesh and the resulting parts.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/measure/report_entry.hpp"

namespace talweg {

/// Counts of the cut, and of every part ("parts.0.faces"). If seams were opened, also whether each
/// curve separates the mesh ("separates.0"), with a warning if not. Lengths in mesh units. `ms`:
/// the time of the cut.
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutMesh& cut,
                                    const MeshParts& made, const std::vector<std::string>& warnings,
                                    double ms);
/// The report of a planned cut, with the whole cut mesh as one part. O(1).
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutPlan& plan,
                                    const std::vector<std::string>& warnings, double ms);

}  // namespace talweg

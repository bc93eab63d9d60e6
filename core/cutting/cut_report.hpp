// A cut report tells what a cut did to a mesh, and what its parts are.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/measure/report_entry.hpp"

namespace talweg {

/// Counts of the cut, and of every part ("parts.0.faces"); where seams were opened, whether each
/// curve separates the mesh ("separates.0"), with a warning where it does not. Lengths in mesh
/// units. `ms`: the time that it took.
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutMesh& cut,
                                    const MeshParts& made, const std::vector<std::string>& warnings,
                                    double ms);
/// The same of a cut that is only planned; the cut mesh is not taken apart. O(1).
std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutPlan& plan,
                                    const std::vector<std::string>& warnings, double ms);

}  // namespace talweg

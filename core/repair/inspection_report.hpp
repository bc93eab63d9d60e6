// An inspection report is what is told of a mesh and its repair, as entries.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg {

struct NearVertices;  // vertex_welding.hpp

/// "usable", "repairable" or "not_usable".
const char* to_string(MeshVerdict verdict);

/// What the mesh is, every kind of defect with its count and first places, and the verdict. What is
/// unknown is infinite. Angles in radians, lengths in mesh units.
std::vector<ReportEntry> entries_of(const MeshInspection& inspection);

/// What a repair did, and the verdict on the mesh after it: the group "repair".
std::vector<ReportEntry> entries_of(const MeshChanges& changes, const MeshInspection& after);

/// How many vertices nearly coincide with others: the group "near_vertices".
std::vector<ReportEntry> entries_of(const NearVertices& near);

/// What welding would give the mesh that was inspected, with a sentence: the group "weld".
std::vector<ReportEntry> entries_of(const std::optional<WeldedMesh>& welded,
                                    const MeshInspection& before);

}  // namespace talweg

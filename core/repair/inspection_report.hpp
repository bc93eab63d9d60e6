// An inspection report describes a mesh and its repair as named entries.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg {

struct NearVertices;  // vertex_welding.hpp

/// "usable", "repairable" or "not_usable".
const char* to_string(MeshVerdict verdict);

/// A kind of defect that a mesh has.
struct DefectWords {
  std::size_t count = 0;
  std::string words;    ///< after the count, with the first places: "faces of zero area: face 3, 8"
  bool blocks = false;  ///< keeps the mesh from being opened
};

/// The kinds of defects that the mesh has, in the order of the report.
std::vector<DefectWords> found_defects(const MeshInspection& inspection);

/// The description of the mesh, every kind of defect with its count and first places, the words of
/// found_defects(), and the verdict. Unknown values are infinite. Angles in radians, lengths in
/// mesh units.
std::vector<ReportEntry> entries_of(const MeshInspection& inspection);

/// The group "repair": the changes of a repair, and the verdict on the repaired mesh.
std::vector<ReportEntry> entries_of(const MeshChanges& changes, const MeshInspection& after);

/// The group "near_vertices": the number of vertices that nearly coincide with others.
std::vector<ReportEntry> entries_of(const NearVertices& near);

/// The group "weld": the result of welding the inspected mesh, with a sentence.
std::vector<ReportEntry> entries_of(const std::optional<WeldedMesh>& welded,
                                    const MeshInspection& before);

}  // namespace talweg

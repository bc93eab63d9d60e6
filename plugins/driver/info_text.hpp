// The info text is the output of `talweg info` about a mesh.
#pragma once

#include <optional>
#include <string>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/repair/vertex_welding.hpp"

namespace talweg::driver {

/// The time for each step, in ms.
struct InfoTimes {
  double load = 0;             ///< reading the file
  double inspect = 0;          ///< finding all defects
  std::optional<double> open;  ///< opening the mesh, if it is usable
};

/// The changes of a repair, and the mesh after it.
struct InfoRepair {
  MeshChanges changes;
  MeshInspection after;
};

/// Readable lines with the verdict last; only defects that the mesh has are listed.
std::string info_text(const MeshInspection& inspection, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair = {},
                      const std::optional<WeldedMesh>& welded = {}, const NearVertices& near = {});

/// The same as JSON with stable keys; every kind of defect is included, with its count and first
/// places. Angles in radians, lengths in mesh units, times in ms.
std::string info_json(const MeshInspection& inspection, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair = {},
                      const std::optional<WeldedMesh>& welded = {}, const NearVertices& near = {});

}  // namespace talweg::driver

// The info text is what `talweg info` says about a mesh.
#pragma once

#include <optional>
#include <string>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg::driver {

/// Where the time went, in ms.
struct InfoTimes {
  double load = 0;             ///< reading the file
  double inspect = 0;          ///< looking for all defects
  std::optional<double> open;  ///< making it ready for curves, where it can be used
};

/// What a repair changes, and what the mesh is after it.
struct InfoRepair {
  MeshChanges changes;
  MeshInspection after;
};

/// Readable lines, the verdict last; only the defects that the mesh has are listed.
std::string info_text(const MeshInspection& inspection, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair = {},
                      const std::optional<WeldedMesh>& welded = {});

/// The same as JSON with stable keys; every defect is there, with its count and first places.
/// Angles in radians, lengths in mesh units, times in ms.
std::string info_json(const MeshInspection& inspection, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair = {},
                      const std::optional<WeldedMesh>& welded = {});

}  // namespace talweg::driver

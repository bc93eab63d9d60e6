// What `talweg info` says about a mesh.
#pragma once

#include <string>

#include "talweg/core/mesh_inspection.hpp"

namespace talweg::driver {

/// Readable lines, the verdict last; only the defects that the mesh has are listed.
std::string info_text(const MeshInspection& inspection);

/// The same as JSON with stable keys; every defect is there, with its count and first places.
/// Angles in radians, lengths in mesh units.
std::string info_json(const MeshInspection& inspection);

}  // namespace talweg::driver

// The demo's vessel, at any resolution.
#pragma once

#include <cstdint>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "tools/scenes/waypoints.hpp"

namespace talweg::scenes {

/// The demo's cell size, centimetres; gives 60,146 faces.
inline constexpr double kVesselCell = 0.0455;

/// The vessel with triangles of about this size. The number of faces is proportional to 1 / cell².
MeshLists vessel_mesh(double cell);

/// A closed line by a trembling hand around the neck of its aneurysm.
Waypoints vessel_loop(const MeshLists& mesh, std::uint64_t seed, int clicks = 26);

}  // namespace talweg::scenes

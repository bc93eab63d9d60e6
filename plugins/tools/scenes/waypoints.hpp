// Vertices that a hand might click on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::scenes {

struct Waypoints {
  std::vector<std::uint32_t> vertices;  ///< different from each other
  bool closed = false;
};

/// The driver's arguments for drawing through these points: "--through 1,2,3", for a closed curve
/// " --closed", and " --points rough", because the points imitate a trembling hand.
std::string draw_arguments(const Waypoints& through);

/// The vertices nearest to these places, without repetitions, ties by index.
/// O(vertices · places).
Waypoints nearest_vertices(const MeshLists& mesh, const std::vector<Point>& places, bool closed);

/// The component with the most faces (the first of several), with its vertices renumbered in their
/// order.
MeshLists largest_component(const MeshLists& mesh);

/// An open, trembling line across the largest component of any mesh: from one end to the other
/// along a shortest edge path between two vertices far apart, with the middle 70 % kept and points
/// moved sideways by a few edges. Deterministic. O(faces log faces). Throws Error(kBadMesh) if the
/// mesh has no faces or is too small to draw on.
Waypoints waypoints_across(const MeshLists& mesh, std::uint64_t seed = 1);

}  // namespace talweg::scenes

// Mesh arrays are a mesh as a host copies it once, before work begins elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drawing.hpp"

namespace talweg::editing {

struct MeshArrays {
  std::vector<std::array<double, 3>> positions;         ///< mesh units
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices, counterclockwise from outside

  bool operator==(const MeshArrays&) const = default;
};

/// The place of a drawing's point in space, mesh units. Throws Error for a face that does not
/// exist.
std::array<double, 3> position_of(const MeshArrays& mesh, const Point& point);

/// The points at some vertices, each in the first triangle that has the vertex. Throws Error if a
/// vertex has no triangle. O(triangles), for any number of vertices.
std::vector<Point> points_at(const MeshArrays& mesh, const std::vector<std::uint32_t>& vertices);

/// The diagonal of the box around all vertices, mesh units; 0 without any.
double diagonal_of(const MeshArrays& mesh);

/// The mean length of edges, mesh units, where those between two triangles count twice; 0 without
/// triangles. Corners that the mesh does not have are passed over.
double mean_edge_of(const MeshArrays& mesh);

/// Views of the lists, which must outlive them.
talweg_array positions_of(const MeshArrays& mesh);
talweg_array triangles_of(const MeshArrays& mesh);

/// Sets the mesh of an instance, which copies it. Throws host::Error.
void set_mesh(host::Instance& instance, const MeshArrays& mesh);

}  // namespace talweg::editing

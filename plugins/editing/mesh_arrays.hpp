// Mesh arrays are a host's copy of a mesh, on which a thread can work while the host changes its
// own.
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

/// The position of a drawing's point, mesh units. Throws Error if the mesh has no such face.
std::array<double, 3> position_of(const MeshArrays& mesh, const Point& point);

/// The points at vertices. A point lies in the first triangle that has the vertex. Throws Error if
/// a vertex has no triangle. O(triangles + vertices).
std::vector<Point> points_at(const MeshArrays& mesh, const std::vector<std::uint32_t>& vertices);

/// The diagonal of the bounding box of all vertices, mesh units; 0 without vertices.
double diagonal_of(const MeshArrays& mesh);

/// The mean length of the triangles' sides, mesh units; 0 without triangles. An edge between two
/// triangles counts twice. A side with a vertex that the mesh does not have counts as 0.
double mean_edge_of(const MeshArrays& mesh);

/// Views of the mesh's lists. The mesh must outlive the views.
talweg_array positions_of(const MeshArrays& mesh);
talweg_array triangles_of(const MeshArrays& mesh);

/// Sets the mesh of an instance. The instance copies the mesh. Throws host::Error.
void set_mesh(host::Instance& instance, const MeshArrays& mesh);

}  // namespace talweg::editing

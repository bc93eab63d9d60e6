#include "tools/picture/outward.hpp"

#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

namespace talweg::picture {

MeshLists turned_outward(MeshLists mesh) {
  // The normals of a closed mesh, weighted by area, add up to zero. The volume of a mesh with holes
  // includes the cones from the rims to the centre.
  constexpr double kHoles = 0.1;  // largest sum of the normals, as a fraction of the area
  Point centre = Point::Zero(), normals = Point::Zero();
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      centre += mesh.points[v] / (3.0 * static_cast<double>(mesh.triangles.size()));
    }
  }
  double volume = 0, area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point p = mesh.points[a] - centre;
    const Point normal = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    volume += p.dot(normal);
    normals += normal;
    area += normal.norm();
  }
  if (volume < 0 && normals.norm() < kHoles * area) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

}  // namespace talweg::picture

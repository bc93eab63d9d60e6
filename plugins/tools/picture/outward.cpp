#include "tools/picture/outward.hpp"

#include <utility>

#include <Eigen/Geometry>

namespace talweg::picture {

MeshLists turned_outward(MeshLists mesh) {
  // The normals of a closed mesh, as long as the areas, add up to zero. The volume of a mesh with
  // holes is that of the mesh with lids that lead to the centre.
  constexpr double kHoles = 0.1;  // part of the area
  Point centre = Point::Zero(), normals = Point::Zero();
  for (const Point& p : mesh.points) centre += p / static_cast<double>(mesh.points.size());
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

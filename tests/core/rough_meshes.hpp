// Rough meshes are smooth meshes with noise along their normals.
#pragma once

#include <random>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::test {

/// Moves each vertex along the normal of its faces by a normally distributed distance with this
/// standard deviation, mesh units.
inline MeshLists roughened(MeshLists lists, double deviation, unsigned seed = 1) {
  std::vector<Point> normals(lists.points.size(), Point::Zero());
  for (const Triangle& t : lists.triangles) {
    const Point& a = lists.points[t[0]];
    const Point normal = (lists.points[t[1]] - a).cross(lists.points[t[2]] - a);
    for (const std::uint32_t corner : t) normals[corner] += normal;
  }
  std::mt19937 random(seed);
  std::normal_distribution<double> deviate(0, deviation);
  for (std::size_t v = 0; v < lists.points.size(); ++v) {
    lists.points[v] += deviate(random) * normals[v].normalized();
  }
  return lists;
}

}  // namespace talweg::test

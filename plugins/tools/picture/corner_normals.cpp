#include "tools/picture/corner_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

namespace talweg::picture {
namespace {

// The corners 3 f + k at every vertex, vertex after vertex.
struct CornersOfVertices {
  std::vector<std::uint32_t> first, corner;
};

CornersOfVertices corners_of_vertices(const MeshLists& mesh) {
  CornersOfVertices result;
  result.first.assign(mesh.points.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++result.first[v + 1];
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) result.first[v + 1] += result.first[v];
  result.corner.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.corner[next[mesh.triangles[f][k]]++] = static_cast<std::uint32_t>(3 * f + k);
    }
  }
  return result;
}

// The normal with twice the face's area as length.
Point normal_of(const MeshLists& mesh, std::size_t f) {
  const auto& [a, b, c] = mesh.triangles[f];
  return (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
}

double largest_area(const MeshLists& mesh) {
  double largest = std::numeric_limits<double>::min();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    largest = std::max(largest, normal_of(mesh, f).norm());
  }
  return largest;
}

}  // namespace

std::vector<Eigen::Vector3f> corner_normals(const MeshLists& mesh, double crease_angle) {
  const std::size_t faces = mesh.triangles.size();
  std::vector<Eigen::Vector3f> area(faces), unit(faces);
  const double largest = largest_area(mesh);  // scales the weights into the range of floats
  for (std::size_t f = 0; f < faces; ++f) {
    const Point n = normal_of(mesh, f);
    const double norm = n.norm();
    area[f] = (n / largest).cast<float>();
    unit[f] = norm > 0 ? Eigen::Vector3f((n / norm).cast<float>()) : Eigen::Vector3f(0, 0, 1);
  }
  const CornersOfVertices around = corners_of_vertices(mesh);
  const auto threshold = static_cast<float>(std::cos(crease_angle));
  std::vector<Eigen::Vector3f> normals(3 * faces);
  for (std::size_t corner = 0; corner < 3 * faces; ++corner) {
    const std::size_t f = corner / 3;
    const std::uint32_t v = mesh.triangles[f][corner % 3];
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::uint32_t i = around.first[v]; i < around.first[v + 1]; ++i) {
      const std::size_t g = around.corner[i] / 3;
      if (unit[f].dot(unit[g]) >= threshold) sum += area[g];
    }
    const float norm = sum.norm();
    normals[corner] = norm > 0 ? Eigen::Vector3f(sum / norm) : unit[f];
  }
  return normals;
}

}  // namespace talweg::picture

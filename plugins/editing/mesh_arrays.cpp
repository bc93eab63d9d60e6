#include "mesh_arrays.hpp"

#include <algorithm>
#include <unordered_map>

#include "vectors.hpp"

namespace talweg::editing {

std::array<double, 3> position_of(const MeshArrays& mesh, const Point& point) {
  if (point.face >= mesh.triangles.size()) {
    throw Error("The mesh has no face " + std::to_string(point.face) + ".");
  }
  std::array<double, 3> position = {0, 0, 0};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto& at = mesh.positions[mesh.triangles[point.face][corner]];
    for (std::size_t i = 0; i < 3; ++i) position[i] += point.barycentric[corner] * at[i];
  }
  return position;
}

std::vector<Point> points_at(const MeshArrays& mesh, const std::vector<std::uint32_t>& vertices) {
  std::unordered_map<std::uint32_t, Point> found;
  for (const std::uint32_t v : vertices) found[v].barycentric = {0, 0, 0};
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto wanted = found.find(mesh.triangles[face][corner]);
      if (wanted == found.end() || wanted->second.barycentric != std::array<double, 3>{0, 0, 0}) {
        continue;
      }
      wanted->second.face = static_cast<std::uint32_t>(face);
      wanted->second.barycentric[corner] = 1;
    }
  }
  std::vector<Point> points;
  for (const std::uint32_t v : vertices) {
    points.push_back(found[v]);
    if (points.back().barycentric == std::array<double, 3>{0, 0, 0}) {
      throw Error("Vertex " + std::to_string(v) + " is not a corner of any face.");
    }
  }
  return points;
}

double diagonal_of(const MeshArrays& mesh) {
  if (mesh.positions.empty()) return 0;
  Vector low = mesh.positions[0], high = low;
  for (const Vector& p : mesh.positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return length(minus(high, low));
}

double mean_edge_of(const MeshArrays& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (std::max(a, b) >= mesh.positions.size()) continue;
      sum += length(minus(mesh.positions[b], mesh.positions[a]));
    }
  }
  return mesh.triangles.empty() ? 0 : sum / static_cast<double>(3 * mesh.triangles.size());
}

talweg_array positions_of(const MeshArrays& mesh) {
  const auto& all = mesh.positions;
  return host::view(all.empty() ? nullptr : all.front().data(), all.size(), 3);
}

talweg_array triangles_of(const MeshArrays& mesh) {
  const auto& all = mesh.triangles;
  return host::view(all.empty() ? nullptr : all.front().data(), all.size(), 3);
}

void set_mesh(host::Instance& instance, const MeshArrays& mesh) {
  instance.set_mesh(positions_of(mesh), triangles_of(mesh));
}

}  // namespace talweg::editing

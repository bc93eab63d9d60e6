#include "tools/scenes/relaxation.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace talweg::scenes {
namespace {

// Neighbours of each vertex; of a boundary vertex only its neighbours along the boundary.
std::vector<std::vector<std::uint32_t>> neighbor_lists(const MeshLists& mesh) {
  std::vector<std::vector<std::uint32_t>> out(mesh.points.size()), result(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) out[t[k]].push_back(t[(k + 1) % 3]);
  }
  const auto has = [&](std::uint32_t a, std::uint32_t b) {
    return std::find(out[a].begin(), out[a].end(), b) != out[a].end();
  };
  std::vector<std::vector<std::uint32_t>> along(mesh.points.size());
  for (std::uint32_t a = 0; a < out.size(); ++a) {
    for (const std::uint32_t b : out[a]) {
      result[a].push_back(b);
      if (has(b, a)) continue;
      result[b].push_back(a);
      along[a].push_back(b);
      along[b].push_back(a);
    }
  }
  for (std::size_t v = 0; v < along.size(); ++v) {
    if (!along[v].empty()) result[v] = along[v];
  }
  return result;
}

Point gradient(const Field& field, const Point& p, double step) {
  Point g;
  for (int k = 0; k < 3; ++k) {
    const Point d = step * Point::Unit(k);
    g[k] = (field(p + d) - field(p - d)) / (2 * step);
  }
  return g;
}

// One bounded Newton step to the zero set.
Point pulled(const Field& field, const Point& p, double step) {
  const Point g = gradient(field, p, 0.1 * step);
  const double square = g.squaredNorm();
  if (!(square > 0)) return p;
  Point move = -field(p) / square * g;
  const double far = move.norm();
  if (far > step) move *= step / far;
  return p + move;
}

}  // namespace

void relax(MeshLists& mesh, const Field& field, double step, int rounds) {
  const auto neighbors = neighbor_lists(mesh);
  std::vector<Point> moved(mesh.points.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < moved.size(); ++v) {
      Point mean = Point::Zero();
      for (const std::uint32_t w : neighbors[v]) mean += mesh.points[w];
      mean /= double(neighbors[v].size());
      moved[v] = pulled(field, 0.5 * (mesh.points[v] + mean), step);
    }
    std::swap(mesh.points, moved);
  }
}

}  // namespace talweg::scenes

// Makes the input of the docs' commands: meshes and curves in the current folder.
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <vector>

#include "talweg/core/drawing/curve_through.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace {

/// A torus of n x n vertices.
talweg::MeshLists torus(std::uint32_t n) {
  talweg::MeshLists lists;
  const double step = 2 * std::numbers::pi / n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const double r = 3 + std::cos(k * step);
      lists.points.emplace_back(r * std::cos(i * step), r * std::sin(i * step), std::sin(k * step));
      const std::uint32_t i2 = (i + 1) % n, k2 = (k + 1) % n;
      lists.triangles.push_back({i * n + k, i2 * n + k, i2 * n + k2});
      lists.triangles.push_back({i * n + k, i2 * n + k2, i * n + k2});
    }
  }
  return lists;
}

void write_case(const std::filesystem::path& folder) {
  std::filesystem::create_directory(folder);
  const talweg::MeshLists lists = torus(40);
  talweg::write_mesh(folder / "mesh.ply", lists);
  const auto mesh = talweg::SurfaceMesh::open(lists);
  const std::vector<talweg::VertexId> ends = {talweg::VertexId{0}, talweg::VertexId{340}};
  const std::vector<talweg::SurfaceCurve> curves = {
      talweg::curve_through(mesh.surface(), talweg::draw_edge_path(mesh.surface(), ends))};
  talweg::write_curves(folder / "curve.mrk.json", mesh, curves);
}

}  // namespace

int main() {
  const talweg::MeshLists vessel = torus(100);
  talweg::write_mesh("vessel.ply", vessel);
  talweg::write_mesh("mesh.obj", vessel);
  std::ofstream distance("distance.txt");  // distance to the circle around the hole through vertex
                                           // 0
  for (const talweg::Point& p : vessel.points) {
    distance << std::abs(std::atan2(p[2], std::hypot(p[0], p[1]) - 3)) << '\n';
  }
  write_case("case1");
  write_case("case2");
}

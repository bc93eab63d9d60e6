#include "sample.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include "talweg/editing/vectors.hpp"

namespace talweg::browser {
namespace {

using editing::MeshArrays;
using editing::Vector;

Vector unit(const Vector& v) { return editing::times(1 / editing::length(v), v); }

MeshArrays icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  MeshArrays mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vector& p : mesh.positions) p = unit(p);
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// Divides every triangle into four, with new vertices on the sphere.
MeshArrays finer(const MeshArrays& mesh) {
  MeshArrays result{mesh.positions, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(result.positions.size()));
    if (is_new) {
      result.positions.push_back(unit(editing::plus(mesh.positions[a], mesh.positions[b])));
    }
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    const std::array<std::uint32_t, 3> four[] = {
        {a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}};
    result.triangles.insert(result.triangles.end(), std::begin(four), std::end(four));
  }
  return result;
}

/// The radius of the stone in a direction, mesh units.
double reach(const Vector& d) {
  const double broad = 1 + 0.16 * d[0] * d[0] - 0.22 * d[2] * d[2];
  const double waves = 0.10 * std::sin(3 * d[0] + 1) * std::cos(2.5 * d[1]) +
                       0.06 * std::sin(6 * d[1] + 2 * d[2]) * std::cos(5 * d[0] - 1);
  const Vector hill = unit({0.3, 0.5, 0.8});
  const double near = editing::length(editing::minus(d, hill));
  return 45 * (broad + waves + 0.22 * std::exp(-8 * near * near));
}

}  // namespace

MeshArrays sample_mesh(int level) {
  MeshArrays mesh = icosahedron();
  for (int k = 0; k < level; ++k) mesh = finer(mesh);
  for (Vector& p : mesh.positions) p = editing::times(reach(p), p);
  return mesh;
}

}  // namespace talweg::browser

#include "tools/paper/ball.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tools/scenes/noise.hpp"

namespace talweg::paper {
namespace {

constexpr std::array<Triangle, 20> kIcosahedron{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::vector<Point> icosahedron_points() {
  constexpr double g = std::numbers::phi;
  std::vector<Point> points{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                            {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                            {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  for (Point& p : points) p.normalize();
  return points;
}

/// Numbers the points of the divided faces; a point on a shared edge gets one number.
class DividedIcosahedron {
 public:
  explicit DividedIcosahedron(std::uint32_t frequency) : n_(frequency) {
    mesh_.points = icosahedron_points();
    for (const Triangle& face : kIcosahedron) divide(face);
  }
  MeshLists take() { return std::move(mesh_); }

 private:
  // The point i steps from corner 0 towards corner 1 and j steps towards corner 2.
  std::uint32_t point(const Triangle& face, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t k = n_ - i - j;
    if (k == n_) return face[0];
    if (i == n_) return face[1];
    if (j == n_) return face[2];
    if (j == 0) return edge_point(face[0], face[1], i);
    if (i == 0) return edge_point(face[0], face[2], j);
    if (k == 0) return edge_point(face[1], face[2], j);
    return add(k * mesh_.points[face[0]] + i * mesh_.points[face[1]] + j * mesh_.points[face[2]]);
  }

  std::uint32_t edge_point(std::uint32_t a, std::uint32_t b, std::uint32_t steps) {
    if (a > b) {
      std::swap(a, b);
      steps = n_ - steps;
    }
    const auto [at, is_new] = first_on_edge_.try_emplace({a, b}, 0);
    if (is_new) {
      at->second = static_cast<std::uint32_t>(mesh_.points.size());
      for (std::uint32_t s = 1; s < n_; ++s) {
        add((n_ - s) * mesh_.points[a] + s * mesh_.points[b]);
      }
    }
    return at->second + steps - 1;
  }

  std::uint32_t add(const Point& p) {
    mesh_.points.push_back(p.normalized());
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  void divide(const Triangle& face) {
    std::vector<std::uint32_t> row, next;
    for (std::uint32_t j = 0; j <= n_; ++j) row.push_back(point(face, 0, j));
    for (std::uint32_t i = 1; i <= n_; ++i) {
      next.clear();
      for (std::uint32_t j = 0; i + j <= n_; ++j) next.push_back(point(face, i, j));
      for (std::size_t j = 0; j < next.size(); ++j) {
        mesh_.triangles.push_back({row[j], next[j], row[j + 1]});
        if (j + 1 < next.size()) mesh_.triangles.push_back({next[j], next[j + 1], row[j + 1]});
      }
      std::swap(row, next);
    }
  }

  std::uint32_t n_;
  MeshLists mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first_on_edge_;
};

}  // namespace

MeshLists sphere(std::uint32_t frequency) { return DividedIcosahedron(frequency).take(); }

void make_bumpy(MeshLists& sphere, std::uint64_t seed) {
  for (Point& p : sphere.points) {
    p *= 1 + 0.3 * scenes::fractal_noise(1.5 * p, 3, seed) + 0.004 * scenes::noise(17 * p, seed);
  }
}

MeshLists bumpy_ball(std::uint32_t frequency, std::uint64_t seed) {
  MeshLists mesh = sphere(frequency);
  make_bumpy(mesh, seed);
  return mesh;
}

}  // namespace talweg::paper

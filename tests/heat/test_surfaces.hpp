// Small surfaces for the tests of the heat layer, from positions known only to the tests.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg::test::inline heat {  // other layers' tests have functions of the same names

using Position = std::array<double, 3>;

inline double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct TestMesh {
  std::vector<Position> positions;
  std::vector<Triangle> triangles;

  [[nodiscard]] Surface surface() const {
    Surface surface = Surface::from_triangles(positions.size(), triangles);
    std::vector<double> lengths(surface.edge_count());
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      lengths[e] = distance(positions[surface.tail(h).index()], positions[surface.head(h).index()]);
    }
    surface.set_lengths(std::move(lengths));
    return surface;
  }
};

/// A rectangle of (columns + 1) × (rows + 1) vertices, spacing 1; vertex (x, y) has the number
/// y (columns + 1) + x. Diagonals alternate, so no direction is preferred.
inline TestMesh grid(std::size_t columns, std::size_t rows) {
  TestMesh mesh;
  const auto id = [&](std::size_t x, std::size_t y) {
    return static_cast<std::uint32_t>(y * (columns + 1) + x);
  };
  for (std::size_t y = 0; y <= rows; ++y) {
    for (std::size_t x = 0; x <= columns; ++x) {
      mesh.positions.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    }
  }
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const auto a = id(x, y), b = id(x + 1, y), c = id(x + 1, y + 1), d = id(x, y + 1);
      if ((x + y) % 2 == 0) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  return mesh;
}

/// The unit sphere: an icosahedron with every triangle split into four, `rounds` times.
/// Vertices 0 and 3 are opposite each other.
inline TestMesh sphere(int rounds) {
  TestMesh mesh;
  const double g = std::numbers::phi;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (fresh) {
        const Position &p = mesh.positions[a], &q = mesh.positions[b];
        mesh.positions.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Position& p : mesh.positions) {
    const double length = distance(p, {0, 0, 0});
    for (double& x : p) x /= length;
  }
  return mesh;
}

/// Both meshes side by side; the second one's vertices follow the first one's.
inline TestMesh together(TestMesh first, const TestMesh& second) {
  const auto offset = static_cast<std::uint32_t>(first.positions.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return first;
}

inline TestMesh scaled(TestMesh mesh, double factor) {
  for (Position& p : mesh.positions) {
    for (double& x : p) x *= factor;
  }
  return mesh;
}

/// A flat band, closed along x: width.size() columns of these widths, `rows` rows of height 1;
/// vertex (x, y) has the number y · columns + x. A torus is closed along y, too; a band has rows +
/// 1 rows of vertices. All diagonals run the same way, so masses and weights are the same as for
/// the five-point stencil, and fields that depend on one coordinate are solved exactly.
inline Surface band(const std::vector<double>& width, std::size_t rows, bool torus) {
  const std::size_t columns = width.size(), levels = torus ? rows : rows + 1;
  const auto id = [&](std::size_t x, std::size_t y) {
    return static_cast<std::uint32_t>((y % levels) * columns + x % columns);
  };
  std::vector<Triangle> triangles;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      triangles.push_back({id(x, y), id(x + 1, y), id(x + 1, y + 1)});
      triangles.push_back({id(x, y), id(x + 1, y + 1), id(x, y + 1)});
    }
  }
  Surface surface = Surface::from_triangles(columns * levels, triangles);
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const double w = width[(f / 2) % columns];
    const HalfedgeId h = surface.halfedge(FaceId{f});
    const std::array<double, 3> side = f % 2 == 0 ? std::array<double, 3>{w, 1, std::hypot(w, 1.0)}
                                                  : std::array<double, 3>{std::hypot(w, 1.0), w, 1};
    lengths[edge_of(h).index()] = side[0];
    lengths[edge_of(surface.next(h)).index()] = side[1];
    lengths[edge_of(surface.prev(h)).index()] = side[2];
  }
  surface.set_lengths(std::move(lengths));
  return surface;
}

inline Surface torus(const std::vector<double>& width, std::size_t rows) {
  return band(width, rows, true);
}

/// Moves every vertex off the grid by a reproducible amount of at most `size` along x and y.
inline TestMesh jittered(TestMesh mesh, double size) {
  std::uint32_t state = 12345;
  const auto next = [&] {
    state = state * 1664525U + 1013904223U;
    return (static_cast<double>(state >> 8U) / 8388608.0 - 1) * size;
  };
  for (Position& p : mesh.positions) {
    p[0] += next();
    p[1] += next();
  }
  return mesh;
}

}  // namespace talweg::test::inline heat

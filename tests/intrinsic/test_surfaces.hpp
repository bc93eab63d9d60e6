// Small surfaces for the tests of the intrinsic layer. Lengths are computed from positions, which
// the library does not see.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg::test {

using Point = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;

inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double norm(const Point& a) { return std::hypot(a[0], a[1], a[2]); }
inline double distance(const Point& a, const Point& b) { return norm(a - b); }

/// Random numbers that are the same on every platform (standard distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

 private:
  std::mt19937_64 engine_;
};

struct TestMesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

inline std::vector<double> lengths_from(const Surface& surface, const std::vector<Point>& points) {
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    lengths[e] = distance(points[surface.tail(h).index()], points[surface.head(h).index()]);
  }
  return lengths;
}

inline Surface surface_of(const TestMesh& mesh) {
  Surface surface = Surface::from_triangles(mesh.points.size(), mesh.triangles);
  surface.set_lengths(lengths_from(surface, mesh.points));
  return surface;
}

/// A grid of (nx + 1) × (ny + 1) vertices; vertex (i, j) is i + j (nx + 1). Inner vertices are
/// moved by up to `jitter` (< 0.25) in x and y.
inline TestMesh grid(std::size_t nx, std::size_t ny, double jitter = 0, std::uint64_t seed = 1) {
  Random random(seed);
  TestMesh mesh;
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      const bool inner = i > 0 && i < nx && j > 0 && j < ny;
      const double dx = inner ? random.uniform(-jitter, jitter) : 0;
      const double dy = inner ? random.uniform(-jitter, jitter) : 0;
      mesh.points.push_back({static_cast<double>(i) + dx, static_cast<double>(j) + dy, 0});
    }
  }
  const auto id = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>(i + j * (nx + 1));
  };
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

/// A grid without the cells for which `drop(i, j)` holds; vertices without faces stay.
template <class Drop>
TestMesh grid_without(std::size_t nx, std::size_t ny, Drop drop) {
  TestMesh mesh = grid(nx, ny);
  std::vector<Triangle> kept;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const std::size_t cell = f / 2;
    if (!drop(cell % nx, cell / nx)) kept.push_back(mesh.triangles[f]);
  }
  mesh.triangles = kept;
  return mesh;
}

/// Rings of n vertices at the given (radius, height), closed around; vertex k of ring r is k + r n.
inline TestMesh rings_of(std::size_t n, const std::vector<std::array<double, 2>>& rings,
                         double twist = 0) {
  TestMesh mesh;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 2 * kPi * (static_cast<double>(k) + twist * static_cast<double>(r)) /
                           static_cast<double>(n);
      mesh.points.push_back(
          {rings[r][0] * std::cos(angle), rings[r][0] * std::sin(angle), rings[r][1]});
    }
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto a = static_cast<std::uint32_t>(k + r * n);
      const auto b = static_cast<std::uint32_t>((k + 1) % n + r * n);
      const auto c = static_cast<std::uint32_t>(b + n), d = static_cast<std::uint32_t>(a + n);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// An open cylinder (a prism over the regular n-gon) of m bands.
inline TestMesh cylinder(std::size_t n, std::size_t m, double radius, double height) {
  std::vector<std::array<double, 2>> rings;
  for (std::size_t r = 0; r <= m; ++r) {
    rings.push_back({radius, height * static_cast<double>(r) / static_cast<double>(m)});
  }
  return rings_of(n, rings);
}

/// A flat annulus.
inline TestMesh annulus(std::size_t n, std::size_t m, double inner, double outer) {
  std::vector<std::array<double, 2>> rings;
  for (std::size_t r = 0; r <= m; ++r) {
    const double s = static_cast<double>(r) / static_cast<double>(m);
    rings.push_back({outer + s * (inner - outer), 0});
  }
  return rings_of(n, rings);
}

/// A cone of m bands with its tip, which is the last vertex; ring m - 1 lies next to the tip.
inline TestMesh cone(std::size_t n, std::size_t m, double radius, double height) {
  std::vector<std::array<double, 2>> rings;
  for (std::size_t r = 0; r < m; ++r) {
    const double s = 1 - static_cast<double>(r) / static_cast<double>(m);
    rings.push_back({radius * s, height * (1 - s)});
  }
  TestMesh mesh = rings_of(n, rings);
  const auto tip = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({0, 0, height});
  for (std::size_t k = 0; k < n; ++k) {
    mesh.triangles.push_back({static_cast<std::uint32_t>((m - 1) * n + k),
                              static_cast<std::uint32_t>((m - 1) * n + (k + 1) % n), tip});
  }
  return mesh;
}

inline TestMesh disc(std::size_t n, std::size_t m) { return cone(n, m, 1, 0); }

inline TestMesh torus(std::size_t n, std::size_t m, double major, double minor) {
  TestMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      const double u = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
      const double v = 2 * kPi * static_cast<double>(j) / static_cast<double>(m);
      const double r = major + minor * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
    }
  }
  const auto id = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>((i % n) * m + j % m);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

inline TestMesh tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

inline TestMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// A unit sphere: each level splits every triangle of an octahedron in four and puts the new
/// vertices on the sphere.
inline TestMesh sphere(int levels) {
  TestMesh mesh = octahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto mid = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)},
                                                  static_cast<std::uint32_t>(mesh.points.size()));
      if (fresh) {
        Point p{};
        for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.points[a][k] + mesh.points[b][k];
        const double size = norm(p);
        mesh.points.push_back({p[0] / size, p[1] / size, p[2] / size});
      }
      return it->second;
    };
    std::vector<Triangle> fine;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = mid(a, b), bc = mid(b, c), ca = mid(c, a);
      fine.insert(fine.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = fine;
  }
  return mesh;
}

/// The surface of the unit cubes for which `solid(i, j, k)` holds, two triangles per square;
/// coordinates are multiplied by `scale`. Cubes of the solid must not touch only along an edge.
template <class Solid>
TestMesh voxels(int nx, int ny, int nz, Solid solid, double scale = 1) {
  TestMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> ids;
  const auto id = [&](std::array<int, 3> p) {
    const auto [it, fresh] = ids.try_emplace(p, static_cast<std::uint32_t>(mesh.points.size()));
    if (fresh) mesh.points.push_back({scale * p[0], scale * p[1], scale * p[2]});
    return it->second;
  };
  const auto filled = [&](const std::array<int, 3>& c) {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < nx && c[1] < ny && c[2] < nz &&
           solid(c[0], c[1], c[2]);
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        if (!filled({i, j, k})) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> beyond = {i, j, k};
            beyond[axis] += side == 1 ? 1 : -1;
            if (filled(beyond)) continue;
            std::array<int, 3> p = {i, j, k};
            p[axis] += side;
            auto q = p, r = p, s = p;
            ++q[(axis + 1) % 3];
            ++r[(axis + 1) % 3];
            ++r[(axis + 2) % 3];
            ++s[(axis + 2) % 3];
            if (side == 0) std::swap(q, s);
            mesh.triangles.push_back({id(p), id(q), id(r)});
            mesh.triangles.push_back({id(p), id(r), id(s)});
          }
        }
      }
    }
  }
  return mesh;
}

inline TestMesh box(int nx, int ny, int nz) {
  return voxels(nx, ny, nz, [](int, int, int) { return true; });
}

/// Genus 2: a slab of 5 × 3 × 1 cubes with two holes, refined `n` times.
inline TestMesh double_torus(int n) {
  return voxels(
      5 * n, 3 * n, n, [n](int i, int j, int) { return j / n != 1 || (i / n != 1 && i / n != 3); },
      1.0 / n);
}

/// A surface of `count` triangles glued along random sides. Multi-edges, self-edges and faces glued
/// to themselves are common. A side stays on the boundary with probability `open`. `spread` = 0
/// draws lengths from [1, 2); otherwise the length of an edge is the sum of the weights of its
/// ends, drawn from 10^[-spread, spread], so a triangle is always valid and often a needle.
inline Surface random_complex(Random& random, std::size_t count, double open, double spread = 0) {
  const std::size_t sides = 3 * count;
  std::vector<std::uint32_t> order(sides);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = sides; i-- > 1;) std::swap(order[i], order[random.below(i + 1)]);
  std::vector<std::uint32_t> gluing(sides, Surface::kNoSide);
  for (std::size_t i = 0; i + 1 < sides; i += 2) {
    if (random.uniform() < open) continue;
    gluing[order[i]] = order[i + 1];
    gluing[order[i + 1]] = order[i];
  }
  std::vector<std::uint32_t> parent(sides);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::size_t c) {
    while (parent[c] != c) c = parent[c];
    return static_cast<std::uint32_t>(c);
  };
  const auto onward = [](std::size_t s) { return s % 3 == 2 ? s - 2 : s + 1; };
  for (std::size_t s = 0; s < sides; ++s) {
    if (gluing[s] == Surface::kNoSide) continue;
    parent[root(s)] = root(onward(gluing[s]));
    parent[root(onward(s))] = root(gluing[s]);
  }
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<Triangle> triangles(count);
  for (std::size_t s = 0; s < sides; ++s) {
    triangles[s / 3][s % 3] =
        number.try_emplace(root(s), static_cast<std::uint32_t>(number.size())).first->second;
  }
  Surface surface = Surface::from_gluing(number.size(), triangles, gluing);
  std::vector<double> weight(number.size());
  for (double& w : weight) w = std::pow(10.0, random.uniform(-spread, spread));
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    lengths[e] = spread > 0 ? weight[surface.tail(h).index()] + weight[surface.head(h).index()]
                            : random.uniform(1, 2);
  }
  surface.set_lengths(lengths);
  return surface;
}

}  // namespace talweg::test

#include "tools/scenes/isosurface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "tools/scenes/waypoints.hpp"

namespace talweg::scenes {
namespace {

// The lattice: corners of cubic cells and the cells' centres, each with its field value.
struct Lattice {
  std::array<std::size_t, 3> size;  // corners along each axis
  Point low;
  double cell;
  std::vector<double> value;  // all corners, then all centres

  [[nodiscard]] std::size_t corner(std::size_t i, std::size_t j, std::size_t k) const {
    return (k * size[1] + j) * size[0] + i;
  }
  [[nodiscard]] std::size_t corner_count() const { return size[0] * size[1] * size[2]; }
  // Centres are stored on the same grid; those of the last layers are unused.
  [[nodiscard]] std::size_t center(std::size_t i, std::size_t j, std::size_t k) const {
    return corner_count() + corner(i, j, k);
  }
  [[nodiscard]] Point position(std::size_t node) const {
    const double half = node >= corner_count() ? 0.5 : 0.0;
    const std::size_t n = node % corner_count();
    const std::size_t i = n % size[0], j = n / size[0] % size[1], k = n / size[0] / size[1];
    const Point grid(double(i) + half, double(j) + half, double(k) + half);
    return low + cell * grid;
  }
};

class Marcher {
 public:
  explicit Marcher(const Lattice& lattice) : lattice_(lattice) {}

  // A tetrahedron of positive volume.
  void visit(std::array<std::size_t, 4> tet) {
    std::size_t inside = 0;
    for (const std::size_t node : tet) inside += lattice_.value[node] < 0;
    if (inside == 0 || inside == 4) return;
    orient(tet);
    // Nodes inside are sorted first, by an even number of swaps, which keeps the orientation.
    std::array<std::size_t, 4> t = tet;
    int swaps = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b) {
        if (!(lattice_.value[t[a]] < 0) && lattice_.value[t[b]] < 0) {
          std::swap(t[a], t[b]);
          ++swaps;
        }
      }
    }
    if (swaps % 2 == 1) {
      if (inside == 1) std::swap(t[1], t[2]);
      if (inside == 2) std::swap(t[2], t[3]);
      if (inside == 3) std::swap(t[0], t[1]);
    }
    const auto cut = [&](std::size_t a, std::size_t b) { return vertex_on(t[a], t[b]); };
    if (inside == 1) add(cut(0, 1), cut(0, 2), cut(0, 3));
    if (inside == 3) add(cut(3, 0), cut(3, 1), cut(3, 2));
    if (inside == 2) {
      const std::uint32_t a = cut(0, 2), b = cut(0, 3), c = cut(1, 3), d = cut(1, 2);
      const bool first = (mesh_.points[a] - mesh_.points[c]).squaredNorm() <=
                         (mesh_.points[b] - mesh_.points[d]).squaredNorm();
      if (first) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(b, c, d);
        add(b, d, a);
      }
    }
  }

  MeshLists take() { return std::move(mesh_); }

 private:
  void orient(std::array<std::size_t, 4>& t) const {
    const Point o = lattice_.position(t[0]);
    const double volume = (lattice_.position(t[1]) - o)
                              .cross(lattice_.position(t[2]) - o)
                              .dot(lattice_.position(t[3]) - o);
    if (volume < 0) std::swap(t[2], t[3]);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({a, b, c});
  }

  std::uint32_t vertex_on(std::size_t inner, std::size_t outer) {
    const auto [low, high] = std::minmax(inner, outer);
    const std::uint64_t key = (std::uint64_t(low) << 32U) | high;
    const auto [found, fresh] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
    if (fresh) {
      const double u = lattice_.value[low], v = lattice_.value[high];
      // Kept away from the ends of the edge, so that no triangle collapses.
      const double t = std::clamp(u / (u - v), 0.12, 0.88);
      mesh_.points.push_back((1 - t) * lattice_.position(low) + t * lattice_.position(high));
    }
    return found->second;
  }

  const Lattice& lattice_;
  MeshLists mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;  // used only for lookups, so its
                                                               // order does not matter
};

Lattice sample(const Field& field, const Point& low, const Point& high, double cell) {
  Lattice lattice{{}, low, cell, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto d = static_cast<Eigen::Index>(axis);
    lattice.size[axis] = static_cast<std::size_t>(std::ceil((high[d] - low[d]) / cell)) + 1;
  }
  lattice.value.resize(2 * lattice.corner_count());
  for (std::size_t node = 0; node < lattice.value.size(); ++node) {
    lattice.value[node] = field(lattice.position(node));
  }
  return lattice;
}

// Removes faces that are joined by one edge only, as the boundary of tetrahedra has: they would
// become slivers when the boundary is smoothed.
void cut_ears(MeshLists& mesh) {
  for (std::size_t before = 0; before != mesh.triangles.size();) {
    before = mesh.triangles.size();
    std::vector<std::uint32_t> faces(mesh.points.size(), 0);
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t v : t) ++faces[v];
    }
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
      return faces[t[0]] == 1 || faces[t[1]] == 1 || faces[t[2]] == 1;
    });
  }
}

}  // namespace

MeshLists isosurface(const Field& field, const Point& low, const Point& high, double cell) {
  const Lattice lattice = sample(field, low, high, cell);
  Marcher marcher(lattice);
  // Every tetrahedron has an edge between two corners and one between two neighbouring centres.
  for (std::size_t k = 1; k + 1 < lattice.size[2]; ++k) {
    for (std::size_t j = 1; j + 1 < lattice.size[1]; ++j) {
      for (std::size_t i = 1; i + 1 < lattice.size[0]; ++i) {
        const std::array<std::size_t, 3> at{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
          std::array<std::size_t, 3> tip = at;
          ++tip[axis];
          std::array<std::size_t, 4> ring{};
          for (std::size_t r = 0; r < 4; ++r) {
            std::array<std::size_t, 3> c = at;
            c[u] -= (r == 1 || r == 2) ? 1U : 0U;
            c[v] -= (r >= 2) ? 1U : 0U;
            ring[r] = lattice.center(c[0], c[1], c[2]);
          }
          const std::size_t a = lattice.corner(i, j, k);
          const std::size_t b = lattice.corner(tip[0], tip[1], tip[2]);
          for (std::size_t r = 0; r < 4; ++r) marcher.visit({a, b, ring[r], ring[(r + 1) % 4]});
        }
      }
    }
  }
  MeshLists mesh = marcher.take();
  cut_ears(mesh);
  return largest_component(mesh);
}

}  // namespace talweg::scenes

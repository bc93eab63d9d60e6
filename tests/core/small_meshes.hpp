// Small meshes of known geometry, and points and curves on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::test {

/// A sheet of (columns x rows) unit squares, each cut from its lower left to its upper right
/// corner; vertex (i, j) has index j · (columns + 1) + i.
inline MeshLists grid(std::uint32_t columns, std::uint32_t rows) {
  MeshLists lists;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) lists.points.push_back(Point(i, j, 0));
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i;
      const std::uint32_t b = a + columns + 1;
      lists.triangles.push_back({a, a + 1, b + 1});
      lists.triangles.push_back({a, b + 1, b});
    }
  }
  return lists;
}

/// A fan of `count` isosceles triangles with legs of length 1 around vertex 0, given by lengths
/// only. The total angle is `cone` (radians). The fan is closed to a disc, or open with vertex 0 on
/// the boundary.
inline Surface fan(std::uint32_t count, double cone, bool closed) {
  std::vector<Triangle> triangles;
  for (std::uint32_t k = 0; k < count; ++k) {
    triangles.push_back({0, 1 + k, closed ? 1 + (k + 1) % count : 2 + k});
  }
  Surface surface = Surface::from_triangles(1 + count + (closed ? 0 : 1), triangles);
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const bool spoke = surface.tail(h).index() == 0 || surface.head(h).index() == 0;
    lengths[e] = spoke ? 1.0 : 2 * std::sin(cone / count / 2);
  }
  surface.set_lengths(lengths);
  return surface;
}

/// A sphere of radius 1: an octahedron whose faces are split into four `levels` times.
inline MeshLists sphere(int levels) {
  MeshLists lists;
  lists.points = {Point(1, 0, 0),  Point(-1, 0, 0), Point(0, 1, 0),
                  Point(0, -1, 0), Point(0, 0, 1),  Point(0, 0, -1)};
  lists.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> made(lists.points.size());
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      if (a > b) std::swap(a, b);
      for (const auto& [other, id] : made[a]) {
        if (other == b) return id;
      }
      const auto id = static_cast<std::uint32_t>(lists.points.size());
      lists.points.push_back((lists.points[a] + lists.points[b]).normalized());
      made[a].emplace_back(b, id);
      return id;
    };
    for (const Triangle& t : lists.triangles) {
      const std::uint32_t a = middle(t[0], t[1]);
      const std::uint32_t b = middle(t[1], t[2]);
      const std::uint32_t c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    lists.triangles = finer;
  }
  return lists;
}

/// The surface of mesh lists without checks.
inline Surface surface_of_lists(const MeshLists& lists) {
  Surface surface = Surface::from_triangles(lists.points.size(), lists.triangles);
  std::vector<double> lengths(surface.edge_count());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    lengths[e] =
        (lists.points[surface.tail(h).index()] - lists.points[surface.head(h).index()]).norm();
  }
  surface.set_lengths(lengths);
  return surface;
}

inline std::vector<VertexId> ids(std::span<const std::uint32_t> numbers) {
  std::vector<VertexId> result;
  for (const std::uint32_t n : numbers) result.push_back(VertexId{n});
  return result;
}
inline std::vector<VertexId> ids(std::initializer_list<std::uint32_t> numbers) {
  return ids(std::span<const std::uint32_t>(numbers.begin(), numbers.size()));
}

inline SurfaceCurve vertex_curve(const Surface& surface, std::span<const VertexId> path,
                                 bool closed) {
  SurfaceCurve curve{closed, {}};
  for (const VertexId v : path) curve.points.push_back(SurfacePoint::at_vertex(surface, v));
  return curve;
}

/// The point inside the edge between two vertices, at fraction t from the first.
inline SurfacePoint between(const Surface& surface, std::uint32_t a, std::uint32_t b, double t) {
  const HalfedgeId h = surface.find_halfedge(VertexId{a}, VertexId{b});
  const EdgeId e = edge_of(h);
  return SurfacePoint::on_edge(surface, e, h == halfedge_of(e) ? t : 1 - t);
}

}  // namespace talweg::test

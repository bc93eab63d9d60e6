// Generated meshes have a known topology, and planted defects.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "core/small_meshes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::test {

/// Joins column i to column i + 1 (mod columns) of a (columns x rows) net of vertices.
inline void add_net(MeshLists& lists, std::uint32_t columns, std::uint32_t rows, bool close_rows) {
  for (std::uint32_t j = 0; j + (close_rows ? 0 : 1) < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * columns + i;
      const std::uint32_t b = j * columns + (i + 1) % columns;
      const std::uint32_t up = (j + 1) % rows * columns;
      lists.triangles.push_back({a, b, up + (i + 1) % columns});
      lists.triangles.push_back({a, up + (i + 1) % columns, up + i});
    }
  }
}

/// An open cylinder of radius 1 and the given height: two boundary loops.
inline MeshLists tube(std::uint32_t columns, std::uint32_t rows, double height) {
  MeshLists lists;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double angle = 2 * std::numbers::pi * i / columns;
      lists.points.emplace_back(std::cos(angle), std::sin(angle), height * j / (rows - 1));
    }
  }
  add_net(lists, columns, rows, false);
  return lists;
}

/// A torus of radii 3 and 1: columns · rows vertices, genus 1.
inline MeshLists torus(std::uint32_t columns, std::uint32_t rows) {
  MeshLists lists;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double u = 2 * std::numbers::pi * j / rows;
      const double v = 2 * std::numbers::pi * i / columns;
      const double r = 3 + std::cos(v);
      lists.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  }
  add_net(lists, columns, rows, true);
  return lists;
}

/// The unit cube, two triangles a side, facing outwards.
inline MeshLists box() {
  MeshLists lists;
  for (int i = 0; i < 8; ++i) lists.points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  lists.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return lists;
}

/// A strip of `length` squares, its ends joined with half a twist: one side, one boundary loop.
inline MeshLists moebius(std::uint32_t length) {
  MeshLists lists;
  for (std::uint32_t i = 0; i < length; ++i) {
    const double u = 2 * std::numbers::pi * i / length;
    for (const double w : {-0.5, 0.5}) {
      const double r = 2 + w * std::cos(u / 2);
      lists.points.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
    }
  }
  for (std::uint32_t i = 0; i < length; ++i) {
    const bool last = i + 1 == length;
    const std::uint32_t a = 2 * i;
    const std::uint32_t low = last ? 1 : a + 2;
    const std::uint32_t high = last ? 0 : a + 3;
    lists.triangles.push_back({a, low, high});
    lists.triangles.push_back({a, high, a + 1});
  }
  return lists;
}

/// Both meshes in one, the second moved by (dx, 0, 0); its ids follow those of the first.
inline MeshLists together(MeshLists first, const MeshLists& second, double dx) {
  const auto shift = static_cast<std::uint32_t>(first.points.size());
  for (const Point& p : second.points) first.points.push_back(p + Point(dx, 0, 0));
  for (const Triangle& t : second.triangles) {
    first.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return first;
}

// Planters: each function adds one defect to a mesh.

inline MeshLists with_index_out_of_range(MeshLists lists, std::size_t face) {
  lists.triangles[face][1] = static_cast<std::uint32_t>(lists.points.size());
  return lists;
}
inline MeshLists with_coordinate(MeshLists lists, std::size_t vertex, double value) {
  lists.points[vertex].y() = value;
  return lists;
}
/// Adds a face that names one of its vertices twice.
inline MeshLists with_repeated_vertex(MeshLists lists) {
  const Triangle t = lists.triangles.front();
  lists.triangles.push_back({t[0], t[1], t[1]});
  return lists;
}
/// Adds a copy of a face: begun at its second corner, or reversed.
inline MeshLists with_duplicate_face(MeshLists lists, std::size_t face, bool reversed) {
  const Triangle t = lists.triangles[face];
  lists.triangles.push_back(reversed ? Triangle{t[2], t[1], t[0]} : Triangle{t[1], t[2], t[0]});
  return lists;
}
/// Adds a fin: a face on the first side of `face`, with a new vertex.
inline MeshLists with_fin(MeshLists lists, std::size_t face) {
  const Triangle t = lists.triangles[face];
  const auto tip = static_cast<std::uint32_t>(lists.points.size());
  lists.points.push_back((lists.points[t[0]] + lists.points[t[1]]) / 2 + Point(0, 0, 5));
  lists.triangles.push_back({t[0], t[1], tip});
  return lists;
}
inline MeshLists with_turned_face(MeshLists lists, std::size_t face) {
  std::swap(lists.triangles[face][1], lists.triangles[face][2]);
  return lists;
}
/// Joins two copies of a mesh at one vertex: a bow-tie.
inline MeshLists with_bow_tie(const MeshLists& lists, std::uint32_t shared) {
  const auto shift = static_cast<std::uint32_t>(lists.points.size());
  MeshLists both = together(lists, lists, 100);
  for (Triangle& t : both.triangles) {
    for (std::uint32_t& v : t) v = v == shared + shift ? shared : v;
  }
  return both;  // vertex shared + shift is isolated now
}
/// Adds a cap of zero area along the first side of `face`, which must be on the boundary.
inline MeshLists with_zero_area_face(MeshLists lists, std::size_t face) {
  const Triangle t = lists.triangles[face];
  const auto middle = static_cast<std::uint32_t>(lists.points.size());
  lists.points.push_back((lists.points[t[0]] + lists.points[t[1]]) / 2);
  lists.triangles.push_back({t[1], t[0], middle});
  return lists;
}
/// Adds a needle: the cap of with_zero_area_face() with its new vertex moved by `height`.
inline MeshLists with_needle(MeshLists lists, std::size_t face, const Point& height) {
  lists = with_zero_area_face(std::move(lists), face);
  lists.points.back() += height;
  return lists;
}
inline MeshLists with_isolated_vertices(MeshLists lists, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) lists.points.emplace_back(7, 8, double(k));
  return lists;
}

/// The sheet [0, 8]² in count² squares.
inline MeshLists sheet(std::uint32_t count) {
  MeshLists lists = grid(count, count);
  for (Point& p : lists.points) p *= 8.0 / count;
  return lists;
}

}  // namespace talweg::test

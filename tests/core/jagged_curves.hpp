// Jagged curves are drawings along edges, with measures that do not use the report.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::test {

/// An edge path through the vertices nearest to these points.
inline SurfaceCurve drawn_near(const SurfaceMesh& mesh, std::span<const Point> points,
                               bool closed) {
  std::vector<VertexId> way;
  for (const Point& p : points) {
    VertexId nearest{0};
    for (std::size_t v = 1; v < mesh.points().size(); ++v) {
      if ((mesh.points()[v] - p).norm() < (mesh.point(nearest) - p).norm()) nearest = VertexId{v};
    }
    if (way.empty() || (way.back() != nearest && way.front() != nearest)) way.push_back(nearest);
  }
  return vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), way, closed), closed);
}

/// Points of a circle in the plane spanned by `right` and `up`.
inline std::vector<Point> circle(const Point& centre, const Point& right, const Point& up,
                                 int count) {
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    points.push_back(centre + std::cos(angle) * right + std::sin(angle) * up);
  }
  return points;
}

/// A sheet of (size x size) squares with hills, on which no two paths have the same length.
inline MeshLists hills(std::uint32_t size) {
  MeshLists lists = grid(size, size);
  for (Point& p : lists.points) {
    const double x = p.x(), y = p.y();
    p += Point(0.2 * std::sin(3 * y), 0.2 * std::cos(5 * x + y),
               2 * std::sin(0.35 * x) * std::cos(0.3 * y));
  }
  return lists;
}

/// A drawing from left to right over hills(40), along a wave of heights 14 and 26.
inline SurfaceCurve wave_on_hills(const SurfaceMesh& mesh) {
  const std::uint32_t way[] = {20 * 41 + 2,  26 * 41 + 8,  24 * 41 + 14, 14 * 41 + 20,
                               16 * 41 + 27, 25 * 41 + 33, 20 * 41 + 38};
  return vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), ids(way)), false);
}

/// The largest distance along the surface, in both directions.
inline double apart(const SurfaceMesh& mesh, std::span<const SurfaceCurve> a,
                    std::span<const SurfaceCurve> b) {
  return DeviationMeter(mesh).measure(a, b).larger().max;
}
inline double apart(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceCurve& b) {
  return apart(mesh, std::span(&a, 1), std::span(&b, 1));
}

inline SurfaceCurve jagged_circle(const SurfaceMesh& mesh, std::uint32_t columns, double radius) {
  std::vector<VertexId> way;
  const double centre = columns / 2.0;
  for (int k = 0; k < 8; ++k) {
    const double angle = std::numbers::pi * k / 4;
    const auto x = static_cast<std::uint32_t>(std::lround(centre + radius * std::cos(angle)));
    const auto y = static_cast<std::uint32_t>(std::lround(centre + radius * std::sin(angle)));
    way.emplace_back(y * (columns + 1) + x);
  }
  return vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), way, true), true);
}

/// A curve of straight lines through these positions, snapped to the mesh.
inline SurfaceCurve straight_through(const SurfaceMesh& mesh, std::vector<Point> points,
                                     bool closed) {
  const CurveInput input{closed, std::move(points), {}};
  return StraightLines(mesh.surface()).join(snap(mesh, input).points, closed);
}

/// Two turns around a tube, the second higher than the first.
inline std::vector<Point> twice_around() {
  std::vector<Point> points;
  for (int k = 0; k < 80; ++k) {
    const double t = 4 * std::numbers::pi * k / 80;
    points.emplace_back(std::cos(t), std::sin(t), 4 - std::cos(t / 2) + (k % 2 == 0 ? 0.1 : -0.1));
  }
  return points;
}

/// A path along rows and columns of a square grid, from each corner to the next.
inline std::vector<VertexId> along_grid(std::uint32_t columns,
                                        const std::vector<std::array<std::uint32_t, 2>>& corners) {
  std::vector<VertexId> way;
  auto [x, y] = corners.front();
  const auto step = [](std::uint32_t from, std::uint32_t to) {
    return from < to ? from + 1 : from > to ? from - 1 : from;
  };
  for (const auto& [to_x, to_y] : corners) {
    for (; x != to_x || y != to_y; x = step(x, to_x), y = step(y, to_y)) {
      way.emplace_back(y * columns + x);
    }
  }
  way.emplace_back(y * columns + x);
  return way;
}

/// A square wave on a grid: runs of `run` edges to the right, with steps of `step` edges up and
/// down in between.
inline SurfaceCurve square_wave(const Surface& surface, std::uint32_t columns, std::uint32_t run,
                                std::uint32_t step) {
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return VertexId{j * (columns + 1) + i}; };
  std::vector<VertexId> way;
  for (std::uint32_t k = 0; k * run < columns; ++k) {
    const std::uint32_t j = 3 + k % 2 * step;
    way.push_back(at(k * run, j));
    way.push_back(at((k + 1) * run, j));
  }
  return vertex_curve(surface, draw_edge_path(surface, way), false);
}

}  // namespace talweg::test

// Jagged curves are drawings, measured here without the report.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::test {

/// An edge path through the vertices that lie nearest to these points.
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

/// A sheet of (size x size) squares with hills, and no two ways of the same length.
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

/// The largest distance along the surface in either direction.
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

}  // namespace talweg::test

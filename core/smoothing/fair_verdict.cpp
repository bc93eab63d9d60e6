#include "talweg/core/smoothing/fair_verdict.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/turning_windows.hpp"

namespace talweg {
namespace {

/// Whether a point is at the boundary, or as near as rounding tells.
bool is_at_boundary(const Surface& surface, const SurfacePoint& point) {
  constexpr double kAtIt = 1e-6;  // of the face's height
  for (const FaceId face : faces_at(surface, point)) {
    const auto b = coordinates_in(surface, point, face).barycentric;
    HalfedgeId side = surface.halfedge(face);  // from corner 0 to corner 1
    for (std::size_t k = 0; k < 3; ++k, side = surface.next(side)) {
      if (surface.on_boundary(edge_of(side)) && b[(k + 2) % 3] <= kAtIt) return true;
    }
  }
  return false;
}

/// How many of a curve's points are at the boundary.
std::size_t boundary_points(const Surface& surface, const SurfaceCurve& curve) {
  return static_cast<std::size_t>(std::ranges::count_if(
      curve.points, [&](const SurfacePoint& point) { return is_at_boundary(surface, point); }));
}

}  // namespace

double bending_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners, double edge) {
  const std::size_t n = curve.points.size();
  const auto is_corner = [&](std::size_t i) {
    return std::find(corners.begin(), corners.end(), curve.points[i % n]) != corners.end();
  };
  std::size_t first = 0;
  while (curve.closed && first < n && !is_corner(first)) ++first;
  if (corners.empty() || first == n) return bending(turns_of(surface, curve), edge);
  double sum = 0;
  SurfaceCurve piece{false, {curve.points[first]}};
  for (std::size_t i = first + 1; i < first + n + (curve.closed ? 1 : 0); ++i) {
    piece.points.push_back(curve.points[i % n]);
    if (!is_corner(i) && i + 1 < n + first + (curve.closed ? 1 : 0)) continue;
    sum += bending(turns_of(surface, piece), edge);
    piece.points.assign(1, curve.points[i % n]);
  }
  return sum;
}

namespace {

/// Of the points that are no corners, without the ends of an open curve.
std::vector<double> turns_between(const Surface& surface, const SurfaceCurve& curve,
                                  std::span<const SurfacePoint> corners) {
  const std::size_t n = curve.points.size();
  const auto point = [&](std::size_t i) -> const SurfacePoint& { return curve.points[i % n]; };
  std::vector<double> turns;
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (std::find(corners.begin(), corners.end(), point(i)) != corners.end()) continue;
    turns.push_back(turning_angle(surface, point(i + n - 1), point(i), point(i + 1)));
  }
  return turns;
}

}  // namespace

double turning_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners) {
  const std::vector<double> turns = turns_between(surface, curve, corners);
  return std::accumulate(turns.begin(), turns.end(), 0.0);
}

double largest_turn_between(const Surface& surface, const SurfaceCurve& curve,
                            std::span<const SurfacePoint> corners) {
  const std::vector<double> turns = turns_between(surface, curve, corners);
  return turns.empty() ? 0 : *std::ranges::max_element(turns);
}

bool is_pressed(const Surface& surface, const SurfaceCurve& curve, const SurfaceCurve& taut) {
  const std::size_t by_itself = boundary_points(surface, taut);
  return by_itself <= 2 && boundary_points(surface, curve) > by_itself;
}

std::vector<SurfacePoint> pressed_points(const Surface& surface, const SurfaceCurve& fair,
                                         const SurfaceCurve& taut) {
  std::vector<SurfacePoint> points;
  if (!is_pressed(surface, fair, taut)) return points;
  std::ranges::copy_if(fair.points, std::back_inserter(points),
                       [&](const SurfacePoint& point) { return is_at_boundary(surface, point); });
  return points;
}

}  // namespace talweg

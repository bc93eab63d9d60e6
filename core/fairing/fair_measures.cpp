#include "talweg/core/fairing/fair_measures.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

/// Whether a face around an edge has a corner at the boundary.
bool is_near_boundary(const Surface& surface, EdgeId edge) {
  for (const HalfedgeId h : {halfedge_of(edge), twin(halfedge_of(edge))}) {
    if (!surface.has_face(h)) return true;
    for (const VertexId v : surface.corners(surface.face(h))) {
      if (surface.on_boundary(v)) return true;
    }
  }
  return false;
}

/// Whether a point is at the boundary, up to rounding.
bool is_at_boundary(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return surface.on_boundary(v->vertex);
  const auto* edge = std::get_if<OnEdge>(&point.where());
  if (edge != nullptr && !is_near_boundary(surface, edge->edge)) return false;
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

/// The number of a curve's points at the boundary.
std::size_t boundary_point_count(const Surface& surface, const SurfaceCurve& curve) {
  return static_cast<std::size_t>(
      std::count_if(curve.points.begin(), curve.points.end(),
                    [&](const SurfacePoint& point) { return is_at_boundary(surface, point); }));
}

/// Calls use() with the turns of each piece of a curve between corners.
template <class Use>
void for_turns_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners, const Use& use) {
  const std::size_t n = curve.points.size();
  const PointLookup turns_freely(corners);
  const auto is_corner = [&](std::size_t i) { return turns_freely.contains(curve.points[i % n]); };
  std::size_t first = 0;
  while (curve.closed && first < n && !is_corner(first)) ++first;
  if (corners.empty() || first == n) {
    use(turns_of(surface, curve));
    return;
  }
  SurfaceCurve piece{false, {curve.points[first]}};
  for (std::size_t i = first + 1; i < first + n + (curve.closed ? 1 : 0); ++i) {
    piece.points.push_back(curve.points[i % n]);
    if (!is_corner(i) && i + 1 < n + first + (curve.closed ? 1 : 0)) continue;
    use(turns_of(surface, piece));
    piece.points.assign(1, curve.points[i % n]);
  }
}

}  // namespace

double bending_between(const Surface& surface, const SurfaceCurve& curve,
                       std::span<const SurfacePoint> corners, double edge) {
  double sum = 0;
  for_turns_between(surface, curve, corners,
                    [&](const CurveTurns& turns) { sum += bending(turns, edge); });
  return sum;
}

bool is_clearly_fair(const Surface& surface, const SurfaceCurve& curve,
                     std::span<const SurfacePoint> corners, double edge) {
  constexpr double kMost = 30 * std::numbers::pi / 180;  // in one edge length
  double most = 0;
  for_turns_between(surface, curve, corners, [&](const CurveTurns& turns) {
    most = std::max(most, window_turning(turns, edge));
  });
  if (most > kMost || largest_turn_between(surface, curve, corners) > kMostFairTurn) return false;
  std::size_t ends = 0;
  if (!curve.closed) {
    ends += is_at_boundary(surface, curve.points.front()) ? 1 : 0;
    ends += is_at_boundary(surface, curve.points.back()) ? 1 : 0;
  }
  return boundary_point_count(surface, curve) <= ends;
}

namespace {

/// Calls look() with the turns at points that are not corners, without the ends of an open curve,
/// until look() returns false.
template <class Look>
void look_at_turns(const Surface& surface, const SurfaceCurve& curve,
                   std::span<const SurfacePoint> corners, const Look& look) {
  const std::size_t n = curve.points.size();
  const PointLookup turns_freely(corners);
  const auto point = [&](std::size_t i) -> const SurfacePoint& { return curve.points[i % n]; };
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (turns_freely.contains(point(i))) continue;
    if (!look(turning_angle(surface, point(i + n - 1), point(i), point(i + 1)))) return;
  }
}

}  // namespace

bool total_turn_reaches(double least, const Surface& surface, const SurfaceCurve& curve,
                        std::span<const SurfacePoint> corners) {
  double sum = 0;
  look_at_turns(surface, curve, corners, [&](double turn) { return (sum += turn) < least; });
  return sum >= least;
}

double largest_turn_between(const Surface& surface, const SurfaceCurve& curve,
                            std::span<const SurfacePoint> corners) {
  double most = 0;
  look_at_turns(surface, curve, corners, [&](double turn) {
    most = std::max(most, turn);
    return true;
  });
  return most;
}

bool has_more_boundary_points(const Surface& surface, const SurfaceCurve& curve,
                              const SurfaceCurve& taut) {
  const std::size_t by_itself = boundary_point_count(surface, taut);
  return by_itself <= 2 && boundary_point_count(surface, curve) > by_itself;
}

std::vector<SurfacePoint> boundary_points_of(const Surface& surface, const SurfaceCurve& fair,
                                             const SurfaceCurve& taut) {
  std::vector<SurfacePoint> points;
  if (!has_more_boundary_points(surface, fair, taut)) return points;
  std::copy_if(fair.points.begin(), fair.points.end(), std::back_inserter(points),
               [&](const SurfacePoint& point) { return is_at_boundary(surface, point); });
  return points;
}

}  // namespace talweg

#include "talweg/core/mesh/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct OnTriangle {
  std::array<double, 3> barycentric{};
  double squared_distance = kInfinity;
};

/// The nearest point of the segment from corner k to corner k + 1.
OnTriangle nearest_on_side(const std::array<Point, 3>& corner, std::size_t k, const Point& p) {
  const std::size_t next = (k + 1) % 3;
  const Point side = corner[next] - corner[k];
  const double length = side.squaredNorm();
  const double t = length > 0 ? std::clamp((p - corner[k]).dot(side) / length, 0.0, 1.0) : 0.0;
  OnTriangle result;
  result.barycentric[k] = 1 - t;
  result.barycentric[next] = t;
  // Interpolation from the nearer end returns an end itself without rounding.
  const Point at = t <= 0.5 ? Point(corner[k] + t * side) : Point(corner[next] - (1 - t) * side);
  result.squared_distance = (p - at).squaredNorm();
  return result;
}

/// The foot of the perpendicular on the triangle; infinitely far if it is not inside or the
/// triangle has no normal.
OnTriangle nearest_inside(const std::array<Point, 3>& corner, const Point& p) {
  OnTriangle result;
  const Point normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return result;
  std::array<double, 3> b{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& from = corner[(k + 1) % 3];
    b[k] = (corner[(k + 2) % 3] - from).cross(p - from).dot(normal) / squared;
    if (!(b[k] > 0)) return result;
  }
  const double sum = b[0] + b[1] + b[2];
  for (double& x : b) x /= sum;
  const Point at = corner[0] + b[1] * (corner[1] - corner[0]) + b[2] * (corner[2] - corner[0]);
  result.barycentric = b;
  result.squared_distance = (p - at).squaredNorm();
  return result;
}

/// Compares the foot and the nearest points of all sides, because rounding can put the foot on a
/// needle far off.
OnTriangle nearest_on_triangle(const std::array<Point, 3>& corner, const Point& p) {
  OnTriangle best = nearest_on_side(corner, 0, p);
  for (const OnTriangle& other :
       {nearest_on_side(corner, 1, p), nearest_on_side(corner, 2, p), nearest_inside(corner, p)}) {
    if (other.squared_distance < best.squared_distance) best = other;
  }
  return best;
}

std::array<Point, 3> corner_points(const SurfaceMesh& mesh, std::size_t face) {
  const auto corners = mesh.surface().corners(FaceId{face});
  return {mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2])};
}

}  // namespace

ClosestPoint::ClosestPoint(const SurfaceMesh& mesh)
    : mesh_(&mesh),
      tree_(
          mesh.surface().face_count(),
          [&](std::uint32_t face) { return SpaceBox::around(corner_points(mesh, face)); },
          BoxTree::Halving::kFast) {
  if (mesh.surface().face_count() == 0) {
    throw Error(ErrorCode::kBadMesh, "The mesh has no face to snap to.");
  }
}

ClosestPoint::Result ClosestPoint::nearest(const Point& position) const {
  if (!position.allFinite()) {
    throw Error(ErrorCode::kBadCurve,
                "A position with a coordinate that is not finite has no "
                "nearest point.");
  }
  const auto on = [&](std::uint32_t face) {
    return nearest_on_triangle(corner_points(*mesh_, face), position);
  };
  const BoxTree::Nearest best =
      tree_.nearest(position, [&](std::uint32_t face) { return on(face).squared_distance; });
  if (!best.found()) {
    throw Error(ErrorCode::kBadCurve, "A position is too far from the mesh to be snapped to it.");
  }
  const FaceId face{best.index};
  const std::array<double, 3> barycentric = on(best.index).barycentric;
  return {SurfacePoint::from_barycentric(mesh_->surface(), face, barycentric), face, barycentric,
          std::sqrt(best.squared_distance)};
}

double distance_to_face(const SurfaceMesh& mesh, FaceId face, const Point& position) {
  return std::sqrt(
      nearest_on_triangle(corner_points(mesh, face.index()), position).squared_distance);
}

std::vector<ClosestPoint::Result> ClosestPoint::on_sheets(const Point& position, double reach,
                                                          std::size_t most) const {
  const Surface& surface = mesh_->surface();
  const auto box_of = [&](std::uint32_t face) {
    return SpaceBox::around(corner_points(*mesh_, face));
  };
  std::unordered_map<FaceId, double> near;
  const Point extent = Point::Constant(reach);
  tree_.visit(SpaceBox{position - extent, position + extent}, box_of, [&](std::uint32_t face) {
    const double distance = distance_to_face(*mesh_, FaceId{face}, position);
    if (distance <= reach) near.emplace(FaceId{face}, distance);
  });
  const auto is_least = [&](FaceId face, double distance) {
    for (const VertexId v : surface.corners(face)) {
      for (const FaceId other : faces_at(surface, SurfacePoint::at_vertex(surface, v))) {
        const auto found = near.find(other);
        if (found != near.end() && std::pair(found->second, other) < std::pair(distance, face)) {
          return false;
        }
      }
    }
    return true;
  };
  std::vector<std::pair<double, FaceId>> least;
  for (const auto& [face, distance] : near) {
    if (is_least(face, distance)) least.emplace_back(distance, face);
  }
  if (least.empty()) return {nearest(position)};
  std::sort(least.begin(), least.end());
  if (least.size() > most) least.resize(most);
  std::vector<Result> results;
  for (const auto& [distance, face] : least) {
    const std::array<double, 3> b =
        nearest_on_triangle(corner_points(*mesh_, face.index()), position).barycentric;
    results.push_back({SurfacePoint::from_barycentric(surface, face, b), face, b, distance});
  }
  return results;
}

}  // namespace talweg

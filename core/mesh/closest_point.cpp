#include "talweg/core/mesh/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::size_t kFacesPerLeaf = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Spreads the low 21 bits to every third bit.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1F00000000FFFFULL;
  x = (x | x << 16) & 0x1F0000FF0000FFULL;
  x = (x | x << 8) & 0x100F00F00F00F00FULL;
  x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

struct Nearness {
  std::uint64_t code;
  std::uint32_t face;
};

/// Stable radix sort by code.
void sort_keys(std::vector<Nearness>& keys) {
  constexpr int kBits = 11;
  constexpr std::size_t kBuckets = std::size_t{1} << kBits;
  std::vector<Nearness> other(keys.size());
  for (int shift = 0; shift < 63; shift += kBits) {
    std::array<std::size_t, kBuckets + 1> start{};
    for (const Nearness& key : keys) ++start[(key.code >> shift & (kBuckets - 1)) + 1];
    for (std::size_t k = 0; k < kBuckets; ++k) start[k + 1] += start[k];
    for (const Nearness& key : keys) other[start[key.code >> shift & (kBuckets - 1)]++] = key;
    keys.swap(other);
  }
}

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
  // From the nearer end, so that an end itself is met without rounding.
  const Point at = t <= 0.5 ? Point(corner[k] + t * side) : Point(corner[next] - (1 - t) * side);
  result.squared_distance = (p - at).squaredNorm();
  return result;
}

/// The foot of the perpendicular, where it lies inside and the triangle has a normal.
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

/// All four candidates, so that a needle's noisy normal cannot give a wrong answer.
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

ClosestPoint::ClosestPoint(const SurfaceMesh& mesh) : mesh_(&mesh) {
  const std::size_t faces = mesh.surface().face_count();
  if (faces == 0) throw Error(ErrorCode::kBadMesh, "The mesh has no face to snap to.");
  while (leaf_count_ * kFacesPerLeaf < faces) leaf_count_ *= 2;
  leaf_size_ = (faces + leaf_count_ - 1) / leaf_count_;
  sort_faces();
  make_boxes();
}

void ClosestPoint::sort_faces() {
  constexpr double kCells = 1 << 21;
  Point low = Point::Constant(kInfinity);
  Point high = -low;
  for (const Point& p : mesh_->points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  const double scale = extent > 0 ? (kCells - 1) / extent : 0.0;
  std::vector<Nearness> keys(mesh_->surface().face_count());
  for (std::size_t f = 0; f < keys.size(); ++f) {
    const auto corner = corner_points(*mesh_, f);
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
      const double centre =
          ((corner[0][k] - low[k]) + (corner[1][k] - low[k]) + (corner[2][k] - low[k])) / 3;
      const double cell = std::clamp(centre * scale, 0.0, kCells - 1);
      code |= spread(static_cast<std::uint64_t>(cell)) << k;
    }
    keys[f] = {code, static_cast<std::uint32_t>(f)};
  }
  sort_keys(keys);
  order_.reserve(keys.size());
  for (const Nearness& key : keys) order_.push_back(key.face);
}

void ClosestPoint::make_boxes() {
  const Box empty{Point::Constant(kInfinity), Point::Constant(-kInfinity)};
  boxes_.assign(2 * leaf_count_, empty);
  for (std::size_t at = 0; at < order_.size(); ++at) {
    Box& box = boxes_[leaf_count_ + at / leaf_size_];
    for (const Point& p : corner_points(*mesh_, order_[at])) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  }
  for (std::size_t k = leaf_count_ - 1; k > 0; --k) {
    boxes_[k].low = boxes_[2 * k].low.cwiseMin(boxes_[2 * k + 1].low);
    boxes_[k].high = boxes_[2 * k].high.cwiseMax(boxes_[2 * k + 1].high);
  }
}

void ClosestPoint::visit(std::size_t leaf, const Point& position, Candidate& best) const {
  const std::size_t end = std::min((leaf + 1) * leaf_size_, order_.size());
  for (std::size_t at = leaf * leaf_size_; at < end; ++at) {
    const std::uint32_t face = order_[at];
    const OnTriangle found = nearest_on_triangle(corner_points(*mesh_, face), position);
    const bool nearer = found.squared_distance < best.squared_distance;
    const bool equal = found.squared_distance == best.squared_distance && face < best.face;
    if (nearer || (best.found && equal)) {
      best = {face, found.barycentric, found.squared_distance, true};
    }
  }
}

ClosestPoint::Result ClosestPoint::nearest(const Point& position) const {
  if (!position.allFinite()) {
    throw Error(ErrorCode::kBadCurve,
                "A position with a coordinate that is not finite has no "
                "nearest point.");
  }
  Candidate best;
  best.squared_distance = kInfinity;
  std::vector<std::pair<std::size_t, double>> stack{{1, boxes_[1].squared_distance(position)}};
  while (!stack.empty()) {
    const auto [node, bound] = stack.back();
    stack.pop_back();
    // Not below the best, but at it: of equally near faces the smallest is wanted.
    if (bound > best.squared_distance) continue;
    if (node >= leaf_count_) {
      visit(node - leaf_count_, position, best);
      continue;
    }
    std::pair<std::size_t, double> near{2 * node, boxes_[2 * node].squared_distance(position)};
    std::pair<std::size_t, double> far{2 * node + 1,
                                       boxes_[2 * node + 1].squared_distance(position)};
    if (far.second < near.second) std::swap(near, far);
    stack.push_back(far);
    stack.push_back(near);
  }
  if (!best.found) {
    throw Error(ErrorCode::kBadCurve, "A position is too far from the mesh to be snapped to it.");
  }
  const FaceId face{best.face};
  return {SurfacePoint::from_barycentric(mesh_->surface(), face, best.barycentric), face,
          best.barycentric, std::sqrt(best.squared_distance)};
}

}  // namespace talweg

#include "talweg/core/smoothing/corridor_width.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr double kStraight = 0.1;            // rad
constexpr double kZigzag = 0.2, kRound = 1;  // rad
constexpr double kOfSegment = 0.7, kOfCurve = 1.0 / 24, kOfRadius = 0.25;

/// Lengths between successive points where the curve has turned, either at one point or gradually
/// since the last. A segment that ends in a smaller turn counts less, because the zigzag is that
/// much narrower.
std::vector<double> segment_lengths(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  const auto point = [&](std::size_t i) -> const SurfacePoint& { return curve.points[i % n]; };
  const auto turn = [&](std::size_t i) {
    const PointTurn found = turn_of(surface, point(i + n - 1), point(i), point(i + 1));
    return found.toward_left < 0 ? -found.angle : found.angle;
  };
  std::size_t first = 0;  // for a closed curve, a point where it turns, if there is one
  while (curve.closed && first + 1 < n && std::abs(turn(first)) <= kStraight) ++first;
  if (first + 1 == n) first = 0;
  std::vector<double> lengths{0};
  double turned = 0;
  for (std::size_t i = first; i + (curve.closed ? 0 : 1) < first + n; ++i) {
    const double here = i > first ? turn(i) : 0;
    turned += here;
    const bool sharp = std::abs(here) > kStraight;
    if (sharp || std::abs(turned) > kStraight) {
      lengths.back() *= sharp ? std::min(1.0, std::abs(here) / kZigzag) : std::abs(turned) / kRound;
      lengths.push_back(0);
      turned = 0;
    }
    lengths.back() += curve_length(surface, {false, {point(i), point(i + 1)}});
  }
  return lengths;
}

}  // namespace

double default_slack(const Surface& surface, const SurfaceCurve& drawn) {
  if (drawn.points.size() < 2) return 0;
  std::vector<double> lengths = segment_lengths(surface, drawn);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return std::min(kOfSegment * *middle, kOfCurve * curve_length(surface, drawn));
}

double corridor_length(const SurfaceMesh& mesh, const SurfaceCurve& drawn) {
  const std::vector<Point> points = positions_of(mesh, drawn);
  const std::size_t n = points.size();
  Point centre = Point::Zero();
  double length = 0, largest = 0;
  for (std::size_t i = 0; i + (drawn.closed ? 0 : 1) < n; ++i) {
    const Point &p = points[i], &q = points[(i + 1) % n];
    centre += (q - p).norm() * ((p + q) / 2 - points[0]);
    length += (q - p).norm();
  }
  if (length > 0) centre /= length;
  centre += points[0];
  for (const Point& p : points) largest = std::max(largest, (p - centre).norm());
  return kOfRadius * largest;
}

double corridor_reach(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge) {
  return 2.5 * corridor_length(mesh, drawn) + 12 * edge;
}

double width_of_loop(const SurfaceMesh& mesh, const SurfaceCurve& drawn) {
  const std::vector<Point> points = positions_of(mesh, drawn);
  Point area = Point::Zero();
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i] - points[0], q = points[(i + 1) % points.size()] - points[0];
    area += p.cross(q) / 2;
    length += (q - p).norm();
  }
  return length > 0 ? area.norm() / (2 * length) : 0;
}

}  // namespace talweg

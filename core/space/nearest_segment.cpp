#include "talweg/core/space/nearest_segment.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

double squared_distance_to(const Segment& s, const Point& p) {
  const Point along = s.b - s.a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - s.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  // The foot is computed from the nearer end, so that a point at an end has distance 0.
  const Point foot = t <= 0.5 ? Point(s.a + t * along) : Point(s.b - (1 - t) * along);
  return (foot - p).squaredNorm();
}

}  // namespace

std::vector<Segment> segments_of(std::span<const Point> points, bool closed) {
  std::vector<Segment> segments;
  if (points.size() == 1) segments.push_back({points[0], points[0]});
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    segments.push_back({points[i], points[i + 1]});
  }
  if (closed && points.size() > 2) segments.push_back({points.back(), points.front()});
  return segments;
}

double distance_to(const Segment& segment, const Point& point) {
  return std::sqrt(squared_distance_to(segment, point));
}

namespace {

std::vector<Segment> checked(std::vector<Segment> segments) {
  if (segments.empty()) {
    throw Error(ErrorCode::kBadCurve, "There is no distance to a curve without points.");
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].a.allFinite() || !segments[i].b.allFinite()) {
      throw Error(ErrorCode::kBadCurve, "Segment " + std::to_string(i) +
                                            " of the curve has a coordinate that is not "
                                            "finite.");
    }
  }
  return segments;
}

}  // namespace

NearestSegment::NearestSegment(std::vector<Segment> segments)
    : segments_(checked(std::move(segments))),
      tree_(
          segments_.size(), [this](std::uint32_t i) { return box_of(i); },
          BoxTree::Halving::kFast) {}

NearestSegment::Result NearestSegment::to(const Point& point) const {
  const BoxTree::Nearest best = tree_.nearest(
      point, [&](std::uint32_t i) { return squared_distance_to(segments_[i], point); });
  return {std::sqrt(best.squared_distance), best.index};
}

}  // namespace talweg

// Nearest point on a set of segments in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

struct Segment {
  Point a;
  Point b;
};

/// The segments of a polyline; a closed one (of three or more points) has a segment from the last
/// point to the first. A single point is one segment of length 0.
std::vector<Segment> segments_of(std::span<const Point> points, bool closed);

/// Distance of a point to a segment.
double distance_to(const Segment& segment, const Point& point);

/// Bounding boxes over segments. Immutable, so many threads may ask.
class SegmentTree {
 public:
  /// O(n log n). Throws Error(kBadCurve) when there is no segment or a coordinate is not finite.
  explicit SegmentTree(std::vector<Segment> segments);

  struct Nearest {
    double distance = 0;      ///< mesh units
    std::size_t segment = 0;  ///< the one of smallest index among those found equally near
  };
  /// The exact nearest segment. O(log n) as a rule.
  [[nodiscard]] Nearest nearest(const Point& point) const;

  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }

 private:
  struct Node {
    Point low;
    Point high;
    std::uint32_t begin = 0;  ///< into order_
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< second child; the first one follows its parent; 0 for a leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Segment> segments_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace talweg

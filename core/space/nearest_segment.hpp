// The nearest segment of many in space is found by a tree of boxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/space/box_tree.hpp"

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

/// Finds the segment nearest to a point. Immutable, so threads may share it.
class NearestSegment {
 public:
  /// O(n). Throws Error(kBadCurve) when there is no segment or a coordinate is not finite.
  explicit NearestSegment(std::vector<Segment> segments);

  struct Result {
    double distance = 0;      ///< mesh units
    std::size_t segment = 0;  ///< the smallest index among equally near segments
  };
  /// The exact nearest segment. O(log n) as a rule.
  [[nodiscard]] Result to(const Point& point) const;

  /// Calls visit(i) for every segment whose box overlaps or touches `box`, always in the same
  /// order.
  template <class Visit>
  void visit_near(const SpaceBox& box, const Visit& visit) const {
    tree_.visit(
        box, [this](std::uint32_t i) { return box_of(i); }, visit);
  }

  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }

 private:
  [[nodiscard]] SpaceBox box_of(std::uint32_t i) const {
    return SpaceBox{segments_[i].a, segments_[i].a}.with({segments_[i].b, segments_[i].b});
  }

  std::vector<Segment> segments_;
  BoxTree tree_;
};

}  // namespace talweg

#include "talweg/core/space/segment_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kLeafSize = 4;

double squared_distance_to_box(const Point& low, const Point& high, const Point& p) {
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

double squared_distance_to(const Segment& s, const Point& p) {
  const Point along = s.b - s.a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - s.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  // From the nearer end, so that a point at an end has distance 0.
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

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)) {
  if (segments_.empty()) {
    throw Error(ErrorCode::kBadCurve, "There is no distance to a curve without points.");
  }
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (!segments_[i].a.allFinite() || !segments_[i].b.allFinite()) {
      throw Error(ErrorCode::kBadCurve, "Segment " + std::to_string(i) +
                                            " of the curve has a coordinate that is not "
                                            "finite.");
    }
  }
  order_.resize(segments_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(2 * (segments_.size() / kLeafSize + 1));
  build(0, static_cast<std::uint32_t>(segments_.size()));
}

/// Splits at the median of the longest side of the midpoints' box.
std::uint32_t SegmentTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  const auto middle_of = [this](std::uint32_t i) -> Point {
    return segments_[i].a + (segments_[i].b - segments_[i].a) / 2;
  };
  Node node;
  node.begin = begin;
  node.end = end;
  node.low = node.high = segments_[order_[begin]].a;
  Point low = middle_of(order_[begin]);
  Point high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Segment& s = segments_[order_[i]];
    node.low = node.low.cwiseMin(s.a).cwiseMin(s.b);
    node.high = node.high.cwiseMax(s.a).cwiseMax(s.b);
    low = low.cwiseMin(middle_of(order_[i]));
    high = high.cwiseMax(middle_of(order_[i]));
  }
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return id;

  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double x = middle_of(i)[axis];
                     const double y = middle_of(j)[axis];
                     return x != y ? x < y : i < j;
                   });
  build(begin, half);
  const std::uint32_t right = build(half, end);
  nodes_[id].right = right;
  return id;
}

SegmentTree::Nearest SegmentTree::nearest(const Point& point) const {
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t found = 0;
  struct Waiting {
    std::uint32_t node;
    double squared;
  };
  std::array<Waiting, 64> stack{};  // the tree halves, so it is at most 32 deep
  std::size_t size = 0;
  stack[size++] = {0, 0};
  while (size > 0) {
    const Waiting top = stack[--size];
    if (top.squared > best) continue;
    const Node& node = nodes_[top.node];
    if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const double squared = squared_distance_to(segments_[order_[i]], point);
        if (squared > best || (squared == best && order_[i] > found)) continue;
        best = squared;
        found = order_[i];
      }
      continue;
    }
    const auto waiting = [&](std::uint32_t child) -> Waiting {
      return {child, squared_distance_to_box(nodes_[child].low, nodes_[child].high, point)};
    };
    Waiting near = waiting(top.node + 1);
    Waiting far = waiting(node.right);
    if (far.squared < near.squared) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  return {std::sqrt(best), found};
}

}  // namespace talweg

// Which of many boxes in space overlap a given one?
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// An upright box in space.
struct SpaceBox {
  Point low, high;

  static SpaceBox around(std::span<const Point> points) {
    SpaceBox box{points[0], points[0]};
    for (const Point& p : points) box = box.with({p, p});
    return box;
  }
  /// Touching counts.
  [[nodiscard]] bool overlaps(const SpaceBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  /// The smallest box around both.
  [[nodiscard]] SpaceBox with(const SpaceBox& other) const {
    return {low.cwiseMin(other.low), high.cwiseMax(other.high)};
  }
};

/// The boxes that a triangle's box overlaps and its plane goes through, but for rounding; where it
/// is but a segment, three planes through that.
class BoxesAtTriangle {
 public:
  BoxesAtTriangle(const Point& a, const Point& b, const Point& c)
      : box_(SpaceBox{a, a}.with({b, b}).with({c, c})), at_(a), planes_{(b - a).cross(c - a)} {
    if (planes_[0].isZero(0)) {
      const Point along = b == a ? Point(c - a) : Point(b - a);
      for (Eigen::Index k = 0; k < 3; ++k) planes_[k] = along.cross(Point::Unit(k));
      count_ = 3;
    }
  }
  [[nodiscard]] bool overlaps(const SpaceBox& box) const {
    if (!box_.overlaps(box)) return false;
    const Point middle = (box.low + box.high) / 2 - at_, half = (box.high - box.low) / 2;
    const double rounding = 1e-14 * (middle.cwiseAbs() + half).sum();
    for (std::size_t k = 0; k < count_; ++k) {
      const Point size = planes_[k].cwiseAbs();
      if (std::abs(planes_[k].dot(middle)) > size.dot(half) + size.maxCoeff() * rounding) {
        return false;
      }
    }
    return true;
  }

 private:
  SpaceBox box_;
  Point at_;
  std::array<Point, 3> planes_;
  std::size_t count_ = 1;
};

/// Halves the boxes by their middles. Immutable. O(n log n) to build; a query is O(log n) as a
/// rule, and what it meets.
class BoxTree {
 public:
  explicit BoxTree(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    if (!order_.empty()) build(0, order_.size());
  }

  /// Calls visit(i) for every box that place.overlaps() says it overlaps, always in the same order;
  /// it must say so of a box around one that it overlaps, too. For example a SpaceBox.
  template <class Place, class Visit>
  void visit(const Place& place, Visit visit) const {
    if (!nodes_.empty()) visit_node(0, place, visit);
  }

 private:
  static constexpr std::size_t kLeaf = 8;

  struct Node {
    SpaceBox box;
    std::size_t begin = 0, end = 0;  // of order_
    std::size_t right = 0;           // the first child follows its parent; 0: no children
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t id = nodes_.size();
    Node node{boxes_[order_[begin]], begin, end, 0};
    for (std::size_t i = begin + 1; i < end; ++i) node.box = node.box.with(boxes_[order_[i]]);
    nodes_.push_back(node);
    if (end - begin <= kLeaf) return id;
    Eigen::Index axis = 0;
    (node.box.high - node.box.low).maxCoeff(&axis);
    const auto middle = [&](std::uint32_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(half), at(end), [&](std::uint32_t i, std::uint32_t k) {
      return middle(i) != middle(k) ? middle(i) < middle(k) : i < k;
    });
    build(begin, half);
    const std::size_t right = build(half, end);
    nodes_[id].right = right;
    return id;
  }

  template <class Place, class Visit>
  void visit_node(std::size_t id, const Place& place, Visit& visit) const {
    const Node& node = nodes_[id];
    if (!place.overlaps(node.box)) return;
    if (node.right != 0) {
      visit_node(id + 1, place, visit);
      visit_node(node.right, place, visit);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      if (place.overlaps(boxes_[order_[i]])) visit(order_[i]);
    }
  }

  std::vector<SpaceBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace talweg

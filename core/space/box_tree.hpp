// A box tree finds the nearest of many objects in space, and objects whose boxes overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// An axis-aligned box in space.
struct SpaceBox {
  Point low, high;

  static SpaceBox around(std::span<const Point> points) {
    SpaceBox box{points[0], points[0]};
    for (const Point& p : points) box = box.with({p, p});
    return box;
  }
  /// Whether the boxes overlap or touch.
  [[nodiscard]] bool overlaps(const SpaceBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  [[nodiscard]] double squared_distance(const Point& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
  }
  /// The smallest box around both.
  [[nodiscard]] SpaceBox with(const SpaceBox& other) const {
    return {low.cwiseMin(other.low), high.cwiseMax(other.high)};
  }
};

/// A place for BoxTree::visit(): the boxes that overlap a triangle's box and meet its plane, up to
/// rounding. For a triangle that is a segment, the boxes must meet three planes through the
/// segment.
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

/// A bounding volume hierarchy: boxes around neighbouring objects, around pairs of these boxes, and
/// so on. An object is a number; queries ask the caller for its box. Immutable, so threads may
/// share a tree. About 25 bytes per object. A query is usually O(log n + objects met).
class BoxTree {
 public:
  using BoxOf = std::function<SpaceBox(std::uint32_t)>;

  /// The rule by which a set of objects is halved, recursively.
  enum class Halving {
    kByMiddles,  ///< by the centers of the boxes: the better tree, O(n log n) to build
    /// Along a space-filling curve if there are more than 2^15 objects (G. M. Morton 1966), O(n) to
    /// build. Only for queries whose answer does not depend on the order in which objects are
    /// visited.
    kFast,
  };
  /// A tree of the objects 0 to count - 1; all boxes must be finite.
  BoxTree(std::size_t count, const BoxOf& box_of, Halving halving = Halving::kByMiddles);

  /// Calls visit(i) for every object whose box satisfies place.overlaps(), always in the same
  /// order. place.overlaps() must also hold for every box around such a box. A SpaceBox is a place.
  template <class Place, class Visit>
  void visit(const Place& place, const BoxOf& box_of, Visit visit) const {
    std::ignore = any_of(place, box_of, [&](std::uint32_t i) {
      visit(i);
      return false;
    });
  }
  /// Whether is_one(i) holds for any object that visit() would visit; stops at the first such
  /// object.
  template <class Place, class IsOne>
  [[nodiscard]] bool any_of(const Place& place, const BoxOf& box_of, IsOne is_one) const {
    return !nodes_.empty() && any_in(0, place, box_of, is_one);
  }

  /// Calls visit(i, k), i < k, once for every pair of objects whose boxes overlap or touch, always
  /// in the same order.
  template <class Visit>
  void visit_pairs(const BoxOf& box_of, Visit visit) const {
    if (!nodes_.empty()) within(0, box_of, visit);
  }

  struct Nearest {
    std::uint32_t index = 0;  ///< the smallest index among equally near objects
    double squared_distance = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool found() const { return std::isfinite(squared_distance); }
  };
  /// The object nearest to a position by `squared_distance(i)`, which must be at least the squared
  /// distance to the box of the object. No object is found if no distance is finite.
  template <class SquaredDistance>
  [[nodiscard]] Nearest nearest(const Point& position,
                                const SquaredDistance& squared_distance) const {
    struct Waiting {
      std::uint32_t node;
      double squared;
    };
    Nearest best;
    if (nodes_.empty()) return best;
    const auto waiting = [&](std::uint32_t node) -> Waiting {
      return {node, nodes_[node].box.squared_distance(position)};
    };
    std::array<Waiting, 64> stack{};  // every level halves, so the tree has less than 32 levels
    std::size_t size = 0;
    stack[size++] = waiting(0);
    while (size > 0) {
      const Waiting top = stack[--size];
      // A node at the best distance is searched, too: among equal objects the smallest index wins.
      if (top.squared > best.squared_distance) continue;
      const Node& node = nodes_[top.node];
      if (node.right == 0) {
        for (const std::uint32_t i : things(node)) {
          const double squared = squared_distance(i);
          const bool equal = squared == best.squared_distance && i < best.index && best.found();
          if (squared < best.squared_distance || equal) best = {i, squared};
        }
        continue;
      }
      Waiting near = waiting(top.node + 1), far = waiting(node.right);
      if (far.squared < near.squared) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
    }
    return best;
  }

 private:
  struct Node {
    SpaceBox box;
    std::uint32_t begin = 0, end = 0;  // range in order_
    std::uint32_t right = 0;           // the first child follows its parent; 0: no children
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, std::span<const SpaceBox> boxes);
  std::uint32_t build_in_order(std::uint32_t begin, std::uint32_t end, const BoxOf& box_of);

  [[nodiscard]] std::span<const std::uint32_t> things(const Node& node) const {
    return std::span(order_).subspan(node.begin, node.end - node.begin);
  }

  template <class Place, class IsOne>
  bool any_in(std::uint32_t id, const Place& place, const BoxOf& box_of, IsOne& is_one) const {
    const Node& node = nodes_[id];
    if (!place.overlaps(node.box)) return false;
    if (node.right != 0) {
      return any_in(id + 1, place, box_of, is_one) || any_in(node.right, place, box_of, is_one);
    }
    const std::span<const std::uint32_t> here = things(node);
    return std::any_of(here.begin(), here.end(),
                       [&](std::uint32_t i) { return place.overlaps(box_of(i)) && is_one(i); });
  }

  template <class Visit>
  void meet(std::uint32_t i, std::uint32_t k, const BoxOf& box_of, Visit& visit) const {
    if (box_of(i).overlaps(box_of(k))) visit(std::min(i, k), std::max(i, k));
  }

  template <class Visit>
  void within(std::uint32_t id, const BoxOf& box_of, Visit& visit) const {
    const Node& node = nodes_[id];
    if (node.right != 0) {
      within(id + 1, box_of, visit);
      within(node.right, box_of, visit);
      between(id + 1, node.right, box_of, visit);
      return;
    }
    const std::span<const std::uint32_t> here = things(node);
    for (std::size_t i = 0; i < here.size(); ++i) {
      for (std::size_t k = i + 1; k < here.size(); ++k) meet(here[i], here[k], box_of, visit);
    }
  }

  template <class Visit>
  void between(std::uint32_t a, std::uint32_t b, const BoxOf& box_of, Visit& visit) const {
    const Node &p = nodes_[a], &q = nodes_[b];
    if (!p.box.overlaps(q.box)) return;
    if (p.right == 0 && q.right == 0) {
      for (const std::uint32_t i : things(p)) {
        for (const std::uint32_t k : things(q)) meet(i, k, box_of, visit);
      }
    } else if (q.right == 0 || (p.right != 0 && p.end - p.begin >= q.end - q.begin)) {
      between(a + 1, b, box_of, visit);
      between(p.right, b, box_of, visit);
    } else {
      between(a, b + 1, box_of, visit);
      between(a, q.right, box_of, visit);
    }
  }

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace talweg

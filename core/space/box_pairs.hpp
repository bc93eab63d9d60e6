// Which of many boxes in the plane overlap?
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace talweg {

/// An upright rectangle.
struct Box {
  std::array<double, 2> low{};   ///< x, y
  std::array<double, 2> high{};  ///< x, y

  /// Touching counts.
  [[nodiscard]] bool overlaps(const Box& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1];
  }
  /// The smallest box around both.
  [[nodiscard]] Box with(const Box& other) const {
    return {{std::min(low[0], other.low[0]), std::min(low[1], other.low[1])},
            {std::max(high[0], other.high[0]), std::max(high[1], other.high[1])}};
  }
};

/// Calls visit(i, k) once for every pair of boxes that overlap or touch, i < k, in no special order
/// but always the same. Halves the boxes by their middles: O(n log n) for n boxes, as a rule, and
/// the pairs.
class BoxPairs {
 public:
  explicit BoxPairs(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    nodes_.reserve(boxes.size() / 2 + 1);
    if (!order_.empty()) build(0, order_.size());
  }

  template <class Visit>
  void visit(Visit visit) const {
    if (!nodes_.empty()) within(0, visit);
  }

 private:
  static constexpr std::size_t kLeaf = 8;

  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;  // of order_
    std::size_t right = 0;           // the first child follows its parent; 0: no children
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t id = nodes_.size();
    Node node{boxes_[order_[begin]], begin, end, 0};
    for (std::size_t i = begin + 1; i < end; ++i) node.box = node.box.with(boxes_[order_[i]]);
    nodes_.push_back(node);
    if (end - begin <= kLeaf) return id;
    const Box& b = node.box;
    const std::size_t axis = b.high[0] - b.low[0] >= b.high[1] - b.low[1] ? 0 : 1;
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

  template <class Visit>
  void meet(std::uint32_t i, std::uint32_t k, Visit& visit) const {
    if (boxes_[i].overlaps(boxes_[k])) visit(std::min(i, k), std::max(i, k));
  }

  template <class Visit>
  void within(std::size_t id, Visit& visit) const {
    const Node& node = nodes_[id];
    if (node.right != 0) {
      within(id + 1, visit);
      within(node.right, visit);
      between(id + 1, node.right, visit);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      for (std::size_t k = i + 1; k < node.end; ++k) meet(order_[i], order_[k], visit);
    }
  }

  template <class Visit>
  void between(std::size_t a, std::size_t b, Visit& visit) const {
    const Node &p = nodes_[a], &q = nodes_[b];
    if (!p.box.overlaps(q.box)) return;
    if (p.right == 0 && q.right == 0) {
      for (std::size_t i = p.begin; i < p.end; ++i) {
        for (std::size_t k = q.begin; k < q.end; ++k) meet(order_[i], order_[k], visit);
      }
    } else if (q.right == 0 || (p.right != 0 && p.end - p.begin >= q.end - q.begin)) {
      between(a + 1, b, visit);
      between(p.right, b, visit);
    } else {
      between(a, b + 1, visit);
      between(a, q.right, visit);
    }
  }

  std::span<const Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace talweg

// A reach tree joins places that lie within reach of each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/core/space/point.hpp"

namespace talweg {

/// Boxes around points and around boxes. A box knows whether all points that were put into it so
/// far are of one group, so that a new one looks at no more than one of them.
class ReachTree {
 public:
  /// `points`, `reach`: per vertex; all three must outlive the tree. The places of `vertices` must
  /// all be different.
  ReachTree(std::span<const Point> points, std::span<const double> reach,
            std::vector<std::uint32_t> vertices, UnionFind& groups);

  /// Joins each two vertices whose distance is at most either's reach. O(n log n) for n vertices;
  /// worse only for many that are all equally far from others.
  void join();

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Node {
    Point low, high;
    std::uint32_t begin = 0, end = 0;  // of vertices_
    std::uint32_t right = 0;           // the first child follows its parent; 0: no children
    std::uint32_t one = kNone;         // a vertex that was put in
    bool mixed = false;                // whether others may be of another group
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  void join_to(std::uint32_t node, std::uint32_t v);
  void put(std::uint32_t place);
  [[nodiscard]] bool is_of_one(const Node& node, std::uint32_t v) {
    return !node.mixed && groups_.find(node.one) == groups_.find(v);
  }

  std::span<const Point> points_;
  std::span<const double> reach_;
  std::vector<std::uint32_t> vertices_;
  std::vector<bool> is_in_;  // by place in vertices_
  std::vector<Node> nodes_;
  UnionFind& groups_;
};

}  // namespace talweg

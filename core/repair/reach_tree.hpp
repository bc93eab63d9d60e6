// A reach tree joins points that lie within reach of each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/core/space/point.hpp"

namespace talweg {

/// A tree of boxes around points. A box records whether all points inserted so far are in one
/// group; a new point of this group skips the box.
class ReachTree {
 public:
  /// `points`, `reach` (mesh units): per vertex. `points`, `reach` and `groups` must outlive the
  /// tree. No two of `vertices` may have the same position.
  ReachTree(std::span<const Point> points, std::span<const double> reach,
            std::vector<std::uint32_t> vertices, UnionFind& groups);

  /// Joins every two vertices whose distance is at most the reach of both. O(n log n) for n
  /// vertices; slower only for many vertices at equal distances from others.
  void join();

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Node {
    Point low, high;
    std::uint32_t begin = 0, end = 0;  // range of vertices_
    std::uint32_t right = 0;           // the first child follows its parent; 0: no children
    std::uint32_t one = kNone;         // an inserted vertex
    bool mixed = false;                // whether inserted vertices may be in different groups
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
  std::vector<bool> is_in_;  // per entry of vertices_, whether it is inserted
  std::vector<Node> nodes_;
  UnionFind& groups_;
};

}  // namespace talweg

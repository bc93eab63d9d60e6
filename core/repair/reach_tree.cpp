#include "talweg/core/repair/reach_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "talweg/core/space/point_distance.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kLeaf = 8;

}  // namespace

ReachTree::ReachTree(std::span<const Point> points, std::span<const double> reach,
                     std::vector<std::uint32_t> vertices, UnionFind& groups)
    : points_(points),
      reach_(reach),
      vertices_(std::move(vertices)),
      is_in_(vertices_.size(), false),
      groups_(groups) {
  if (!vertices_.empty()) build(0, static_cast<std::uint32_t>(vertices_.size()));
}

std::uint32_t ReachTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.low = node.high = points_[vertices_[begin]];
  for (std::uint32_t i = begin; i < end; ++i) {
    node.low = node.low.cwiseMin(points_[vertices_[i]]);
    node.high = node.high.cwiseMax(points_[vertices_[i]]);
  }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return id;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const std::span<std::uint32_t> here = std::span(vertices_).subspan(begin, end - begin);
  std::nth_element(
      here.begin(), here.begin() + (middle - begin), here.end(),
      [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[id].right = right;
  return id;
}

/// Vertices with a longer reach are inserted first. Two vertices are then joined if their distance
/// is at most the smaller reach, which is the reach of the vertex inserted later.
void ReachTree::join() {
  std::vector<std::uint32_t> by_reach(vertices_.size());
  std::iota(by_reach.begin(), by_reach.end(), 0U);
  std::stable_sort(by_reach.begin(), by_reach.end(), [&](std::uint32_t i, std::uint32_t k) {
    return reach_[vertices_[i]] > reach_[vertices_[k]];
  });
  for (const std::uint32_t place : by_reach) {
    join_to(0, vertices_[place]);
    put(place);
  }
}

void ReachTree::join_to(std::uint32_t id, std::uint32_t v) {
  Node& node = nodes_[id];
  if (node.one == kNone || is_of_one(node, v)) return;
  const Point& p = points_[v];
  // Rounding of distances must not exclude a box that contains a point within reach.
  constexpr double kRounding = 1 + 1e-12;
  const Point nearest = p.cwiseMax(node.low).cwiseMin(node.high);
  if (point_distance(p, nearest) > reach_[v] * kRounding) return;
  if (node.right != 0) {
    join_to(id + 1, v);
    join_to(node.right, v);
    const Node &left = nodes_[id + 1], &right = nodes_[node.right];
    node.mixed = left.mixed || right.mixed ||
                 (left.one != kNone && right.one != kNone &&
                  groups_.find(left.one) != groups_.find(right.one));
    return;
  }
  node.mixed = false;
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    if (!is_in_[i]) continue;
    if (point_distance(points_[vertices_[i]], p) <= reach_[v]) groups_.join(v, vertices_[i]);
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    if (is_in_[i] && !(groups_.find(vertices_[i]) == groups_.find(node.one))) node.mixed = true;
  }
}

/// Inserts a vertex into the boxes around it, from the outermost.
void ReachTree::put(std::uint32_t place) {
  is_in_[place] = true;
  const std::uint32_t v = vertices_[place];
  for (std::uint32_t id = 0;;) {
    Node& node = nodes_[id];
    if (node.one == kNone) {
      node.one = v;
    } else if (!is_of_one(node, v)) {
      node.mixed = true;
    }
    if (node.right == 0) return;
    id = place < nodes_[node.right].begin ? id + 1 : node.right;
  }
}

}  // namespace talweg

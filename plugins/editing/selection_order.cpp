#include "selection_order.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace talweg::editing {
namespace {

using Vertex = std::uint32_t;
using Neighbours = std::map<Vertex, std::set<Vertex>>;  // ordered, so that results are reproducible

constexpr Vertex kNone = UINT32_MAX;

void require_no_branch(const Neighbours& neighbours) {
  for (const auto& [vertex, others] : neighbours) {
    if (others.size() > 2) {
      throw Error("The selection has no order: it branches at vertex " + std::to_string(vertex) +
                  ".");
    }
  }
}

/// Walks from `start` to the end of the chain, or around the ring.
OrderedVertices walk(const Neighbours& neighbours, Vertex start) {
  OrderedVertices chain;
  Vertex before = kNone, at = start;
  while (true) {
    chain.vertices.push_back(at);
    Vertex next = kNone;
    for (const Vertex other : neighbours.at(at)) {
      if (other != before && next == kNone) next = other;
    }
    if (next == kNone) return chain;
    if (next == start) {
      chain.closed = true;
      return chain;
    }
    before = at;
    at = next;
  }
}

/// Chains and rings of a graph without branches; each vertex belongs to exactly one.
std::vector<OrderedVertices> chains_of(const Neighbours& neighbours) {
  require_no_branch(neighbours);
  std::vector<OrderedVertices> result;
  std::set<Vertex> used;
  const auto take = [&](Vertex start) {
    if (used.count(start) != 0) return;
    result.push_back(walk(neighbours, start));
    used.insert(result.back().vertices.begin(), result.back().vertices.end());
  };
  for (const auto& [vertex, others] : neighbours) {
    if (others.size() == 1) take(vertex);
  }
  for (const auto& [vertex, others] : neighbours) {
    if (others.size() == 2) take(vertex);
  }
  return result;
}

/// A path of edges between two selected vertices without a third one on it.
struct Joint {
  std::uint32_t edges;
  Vertex a, b;
  auto operator<=>(const Joint&) const = default;
};

/// The triangles around each vertex: those of vertex v are faces[begin[v]] to faces[begin[v + 1]].
struct Stars {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> faces;
};

Stars stars_of(const MeshArrays& mesh) {
  Stars stars;
  stars.begin.assign(mesh.positions.size() + 2, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const Vertex v : triangle) ++stars.begin[v + 2];
  }
  std::partial_sum(stars.begin.begin(), stars.begin.end(), stars.begin.begin());
  stars.faces.resize(3 * mesh.triangles.size());
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const Vertex v : mesh.triangles[face]) {
      stars.faces[stars.begin[v + 1]++] = static_cast<std::uint32_t>(face);
    }
  }
  return stars;
}

/// Breadth-first search from all selected vertices at once finds the nearest selected vertex of
/// each vertex, and its distance in edges. A joint lies where the fronts of two selected vertices
/// meet.
std::vector<Joint> joints_between(const MeshArrays& mesh, const std::vector<Vertex>& selected) {
  const Stars stars = stars_of(mesh);
  std::vector<Vertex> nearest(mesh.positions.size(), kNone);
  std::vector<std::uint32_t> away(mesh.positions.size(), 0);
  std::deque<Vertex> front(selected.begin(), selected.end());
  for (const Vertex v : selected) nearest[v] = v;
  while (!front.empty()) {
    const Vertex v = front.front();
    front.pop_front();
    for (std::size_t k = stars.begin[v]; k < stars.begin[v + 1]; ++k) {
      for (const Vertex w : mesh.triangles[stars.faces[k]]) {
        if (nearest[w] != kNone) continue;
        nearest[w] = nearest[v];
        away[w] = away[v] + 1;
        front.push_back(w);
      }
    }
  }
  std::map<std::pair<Vertex, Vertex>, std::uint32_t> least;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex v = triangle[i], w = triangle[(i + 1) % 3];
      if (nearest[v] == nearest[w] || nearest[v] == kNone || nearest[w] == kNone) continue;
      const std::uint32_t edges = away[v] + away[w] + 1;
      const auto [at, is_new] = least.try_emplace(std::minmax(nearest[v], nearest[w]), edges);
      if (!is_new) at->second = std::min(at->second, edges);
    }
  }
  std::vector<Joint> joints;
  joints.reserve(least.size());
  for (const auto& [pair, edges] : least) joints.push_back({edges, pair.first, pair.second});
  std::sort(joints.begin(), joints.end());
  return joints;
}

class Groups {
 public:
  explicit Groups(const std::vector<Vertex>& members) {
    for (const Vertex v : members) above_[v] = v;
  }
  Vertex of(Vertex v) {
    while (above_.at(v) != v) v = above_.at(v) = above_.at(above_.at(v));
    return v;
  }
  bool join(Vertex a, Vertex b) {
    if (of(a) == of(b)) return false;
    above_[of(a)] = of(b);
    return true;
  }

 private:
  std::map<Vertex, Vertex> above_;
};

using Lengths = std::map<std::pair<Vertex, Vertex>, std::uint32_t>;

/// At a sharp turn of a curve, the vertices before and after the corner are neighbours, too, and
/// the tree may have joined them. The corner is then a leaf beside the chain. The function moves
/// one such leaf into the chain, and returns false if there is none.
bool take_in_a_leaf(Neighbours& neighbours, const Lengths& lengths) {
  for (const auto& [leaf, others] : neighbours) {
    if (others.size() != 1) continue;
    const Vertex v = *others.begin();
    if (neighbours.at(v).size() < 3) continue;
    for (const Vertex u : neighbours.at(v)) {
      const auto joint = lengths.find(std::minmax(leaf, u));
      if (u == leaf || joint == lengths.end()) continue;
      if (joint->second > lengths.at(std::minmax(leaf, v))) continue;
      neighbours.at(v).erase(u);
      neighbours.at(u).erase(v);
      neighbours.at(u).insert(leaf);
      neighbours.at(leaf).insert(u);
      return true;
    }
  }
  return false;
}

/// Joins neighbours, which are the joints of one edge, into chains.
void join_neighbours(const std::vector<Joint>& joints, const std::vector<Vertex>& selected,
                     const Lengths& lengths, Neighbours& neighbours) {
  Groups groups(selected);
  for (const Joint& joint : joints) {
    if (joint.edges > 1 || !groups.join(joint.a, joint.b)) continue;
    neighbours[joint.a].insert(joint.b);
    neighbours[joint.b].insert(joint.a);
  }
  while (take_in_a_leaf(neighbours, lengths)) {
  }
  require_no_branch(neighbours);
}

/// Closes chains of three or more vertices if the joint between the ends is no longer than the
/// longest joint inside the chain.
void close_rings(const Lengths& lengths, Neighbours& neighbours) {
  for (const OrderedVertices& chain : chains_of(neighbours)) {
    const std::vector<Vertex>& v = chain.vertices;
    if (chain.closed || v.size() < 3) continue;
    std::uint32_t longest = 0;
    for (std::size_t k = 0; k + 1 < v.size(); ++k) {
      longest = std::max(longest, lengths.at(std::minmax(v[k], v[k + 1])));
    }
    const auto last = lengths.find(std::minmax(v.front(), v.back()));
    if (last == lengths.end() || last->second > longest) continue;
    neighbours[v.front()].insert(v.back());
    neighbours[v.back()].insert(v.front());
  }
}

/// Joins chains and single vertices at their ends, shortest joints first. Rings are not joined. A
/// joint that is much longer than the longest joint inside its chains is not used.
void join_ends(const std::vector<Joint>& joints, const std::vector<Vertex>& selected,
               Neighbours& neighbours) {
  constexpr std::uint32_t kMuchLonger = 4;
  Groups groups(selected);
  std::map<Vertex, std::uint32_t> longest;  // by group; 0 for a single vertex
  for (const auto& [vertex, others] : neighbours) {
    for (const Vertex other : others) groups.join(vertex, other);
  }
  for (const auto& [vertex, others] : neighbours) longest[groups.of(vertex)] = 1;
  for (const Joint& joint : joints) {
    const Vertex a = groups.of(joint.a), b = groups.of(joint.b);
    const std::uint32_t most = std::max(longest[a], longest[b]);
    if (a == b || (most > 0 && joint.edges > kMuchLonger * most)) continue;
    if (neighbours[joint.a].size() > 1 || neighbours[joint.b].size() > 1) continue;
    groups.join(a, b);
    longest[groups.of(a)] = std::max(most, joint.edges);
    neighbours[joint.a].insert(joint.b);
    neighbours[joint.b].insert(joint.a);
  }
}

}  // namespace

std::vector<OrderedVertices> order_along_mesh(const MeshArrays& mesh,
                                              const std::vector<std::uint32_t>& vertices) {
  const std::set<Vertex> distinct(vertices.begin(), vertices.end());
  const std::vector<Vertex> selected(distinct.begin(), distinct.end());
  if (!selected.empty() && selected.back() >= mesh.positions.size()) {
    throw Error("The mesh has no vertex " + std::to_string(selected.back()) + ".");
  }
  const std::vector<Joint> joints = joints_between(mesh, selected);
  Lengths lengths;
  for (const Joint& joint : joints) lengths[{joint.a, joint.b}] = joint.edges;
  Neighbours neighbours;
  join_neighbours(joints, selected, lengths, neighbours);
  close_rings(lengths, neighbours);
  join_ends(joints, selected, neighbours);
  close_rings(lengths, neighbours);
  return chains_of(neighbours);
}

namespace {

Neighbours neighbours_along(const std::vector<std::array<std::uint32_t, 2>>& edges) {
  Neighbours neighbours;
  for (const auto& [a, b] : edges) {
    if (a == b) throw Error("An edge runs from vertex " + std::to_string(a) + " to itself.");
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  return neighbours;
}

/// Walks from `start` over `next` up to a vertex where the edges end or branch, and removes the
/// edges of the walk from `left`.
OrderedVertices taken_walk(const Neighbours& all, Neighbours& left, Vertex start, Vertex next) {
  OrderedVertices chain;
  chain.vertices = {start};
  for (Vertex at = start; true; next = *left[at].begin()) {
    left[at].erase(next);
    left[next].erase(at);
    at = next;
    chain.closed = at == start;
    if (!chain.closed) chain.vertices.push_back(at);
    if (chain.closed || all.at(at).size() != 2) return chain;
  }
}

}  // namespace

std::vector<OrderedVertices> order_along_edges(
    const std::vector<std::array<std::uint32_t, 2>>& edges) {
  return chains_of(neighbours_along(edges));
}

std::vector<OrderedVertices> order_between_branches(
    const std::vector<std::array<std::uint32_t, 2>>& edges) {
  const Neighbours all = neighbours_along(edges);
  Neighbours left = all;
  std::vector<OrderedVertices> result;
  for (const bool rings : {false, true}) {
    for (const auto& [vertex, others] : all) {
      if (!rings && others.size() == 2) continue;
      while (!left[vertex].empty()) {
        result.push_back(taken_walk(all, left, vertex, *left[vertex].begin()));
      }
    }
  }
  return result;
}

}  // namespace talweg::editing

// Label parts are the connected parts of regions, and the degrees of the nodes of their borders.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg::test {

using Labels = std::vector<std::int64_t>;

/// The number of parts of each label. Faces of one label that share an edge are one part.
inline std::map<std::int64_t, std::size_t> parts(const MeshLists& lists, const Labels& labels) {
  UnionFind sets(labels.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> at;
  for (std::uint32_t f = 0; f < labels.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [p, q] = std::minmax(lists.triangles[f][c], lists.triangles[f][(c + 1) % 3]);
      const auto [other, is_new] = at.emplace(std::pair(p, q), f);
      if (!is_new && labels[other->second] == labels[f]) sets.join(f, other->second);
    }
  }
  std::map<std::int64_t, std::size_t> count;
  for (std::uint32_t f = 0; f < labels.size(); ++f) count[labels[f]] += sets.find(f) == f ? 1 : 0;
  return count;
}

/// The number of parts of each label per vertex, without isolated vertices.
inline std::map<std::int64_t, std::size_t> parts_of_vertices(const Surface& surface,
                                                             const Labels& labels) {
  UnionFind sets(labels.size());
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const auto p = static_cast<std::uint32_t>(surface.tail(h).index());
    const auto q = static_cast<std::uint32_t>(surface.head(h).index());
    if (labels[p] == labels[q]) sets.join(p, q);
  }
  std::map<std::int64_t, std::size_t> count;
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    if (surface.halfedge(VertexId{v}).valid()) count[labels[v]] += sets.find(v) == v ? 1 : 0;
  }
  return count;
}

/// The number of edges between different labels at each vertex where this number is not two.
inline std::multiset<std::size_t> degrees(const MeshLists& lists, const Labels& labels) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> other;
  std::map<std::uint32_t, std::size_t> meeting;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t p = lists.triangles[f][c], q = lists.triangles[f][(c + 1) % 3];
      const auto found = other.find({q, p});
      if (found == other.end()) {
        other.emplace(std::pair(p, q), labels[f]);
      } else if (found->second != labels[f]) {
        ++meeting[p];
        ++meeting[q];
      }
    }
  }
  std::multiset<std::size_t> result;
  for (const auto& [vertex, count] : meeting) {
    if (count != 2) result.insert(count);
  }
  return result;
}

}  // namespace talweg::test

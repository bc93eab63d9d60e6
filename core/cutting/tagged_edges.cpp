#include "talweg/core/cutting/tagged_edges.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace talweg {
namespace {

using EdgeKey = std::uint64_t;
EdgeKey edge_key(std::uint32_t a, std::uint32_t b) {
  return (EdgeKey{std::min(a, b)} << 32U) | std::max(a, b);
}
using Edge = std::array<std::uint32_t, 2>;

}  // namespace

std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const std::uint32_t> from,
                                     std::span<const CutMesh::Chain> chains) {
  std::unordered_map<EdgeKey, std::vector<Edge>> here;  // by the edge, in the chains' numbers
  std::uint32_t last = 0;
  for (const CutMesh::Chain& chain : chains) {
    for (const std::uint32_t v : chain.vertices) last = std::max(last, v);
    const std::size_t n = chain.vertices.size();
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < n; ++i) {
      here[edge_key(chain.vertices[i], chain.vertices[(i + 1) % n])];
    }
  }
  std::vector<bool> on_chain(std::size_t{last} + 1, false);
  for (const CutMesh::Chain& chain : chains) {
    for (const std::uint32_t v : chain.vertices) on_chain[v] = true;
  }
  const auto marked = [&](std::uint32_t v) { return from[v] <= last && on_chain[from[v]]; };
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!marked(a) || !marked(b)) continue;
      const auto found = here.find(edge_key(from[a], from[b]));
      if (found == here.end()) continue;
      const Edge edge{std::min(a, b), std::max(a, b)};
      auto& there = found->second;
      if (std::find(there.begin(), there.end(), edge) == there.end()) there.push_back(edge);
    }
  }
  std::vector<TaggedEdge> edges;
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    const auto& vertices = chains[c].vertices;
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i + (chains[c].closed ? 0 : 1) < n; ++i) {
      const std::uint32_t a = vertices[i], b = vertices[(i + 1) % n];
      for (const auto& [u, v] : here[edge_key(a, b)]) {
        const bool along = from[u] == a;
        edges.push_back({along ? u : v, along ? v : u, c});
      }
    }
  }
  return edges;
}

}  // namespace talweg

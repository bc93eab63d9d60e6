#include "talweg/core/cutting/tagged_edges.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace talweg {
namespace {

using EdgeKey = std::uint64_t;
EdgeKey edge_key(std::uint32_t a, std::uint32_t b) {
  return (EdgeKey{std::min(a, b)} << 32U) | std::max(a, b);
}

/// The edges between vertices of curves, numbered in the order of the triangles.
std::unordered_map<EdgeKey, std::size_t> edges_between(std::span<const Triangle> triangles,
                                                       std::span<const PartOrigins::Curve> curves) {
  std::vector<bool> on_curve;
  for (const PartOrigins::Curve& curve : curves) {
    for (const auto& place : curve.vertices) {
      for (const std::uint32_t v : place) {
        if (v >= on_curve.size()) on_curve.resize(std::size_t{v} + 1, false);
        on_curve[v] = true;
      }
    }
  }
  const auto marked = [&](std::uint32_t v) { return v < on_curve.size() && on_curve[v]; };
  std::unordered_map<EdgeKey, std::size_t> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (marked(a) && marked(b)) edges.emplace(edge_key(a, b), edges.size());
    }
  }
  return edges;
}

}  // namespace

std::vector<TaggedEdge> tagged_edges(std::span<const Triangle> triangles,
                                     std::span<const PartOrigins::Curve> curves) {
  const auto there = edges_between(triangles, curves);
  std::vector<TaggedEdge> edges;
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    const auto& places = curves[c].vertices;
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < places.size(); ++i) {
      std::vector<std::pair<std::size_t, TaggedEdge>> here;
      for (const std::uint32_t a : places[i]) {
        for (const std::uint32_t b : places[(i + 1) % places.size()]) {
          const auto found = there.find(edge_key(a, b));
          if (found != there.end()) here.push_back({found->second, {a, b, c}});
        }
      }
      std::sort(here.begin(), here.end(),
                [](const auto& x, const auto& y) { return x.first < y.first; });
      for (const auto& [number, edge] : here) edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace talweg

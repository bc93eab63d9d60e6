#include "talweg/core/loop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace talweg {
namespace {

using Loop = std::vector<std::uint32_t>;

constexpr std::size_t kMost = 256;

/// Area, and a little for long sides, which decides between triangulations of a plane polygon.
double cost(const Point& a, const Point& b, const Point& c) {
  constexpr double kShape = 1e-6;
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return (b - a).cross(c - a).norm() / 2 + kShape * sides;
}

/// By dynamic programming over stretches of the polygon.
void fill_short(const std::vector<Point>& points, const Loop& loop,
                std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  if (n < 3) return;
  std::vector<double> least(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t width = 2; width < n; ++width) {
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t k = i + width;
      double best = HUGE_VAL;
      for (std::size_t j = i + 1; j < k; ++j) {
        const double sum = least[i * n + j] + least[j * n + k] +
                           cost(points[loop[i]], points[loop[j]], points[loop[k]]);
        if (sum >= best) continue;
        best = sum;
        apex[i * n + k] = static_cast<std::uint32_t>(j);
      }
      least[i * n + k] = best;
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k < i + 2) continue;
    const std::size_t j = apex[i * n + k];
    triangles.push_back({loop[i], loop[j], loop[k]});
    open.emplace_back(i, j);
    open.emplace_back(j, k);
  }
}

/// Whether the loop runs along one seam on both sides, so that a lid would have no area.
template <class Original>
bool is_slit(const Loop& loop, const Original& original) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = original(loop[i]), b = original(loop[(i + 1) % loop.size()]);
    if (!edges.insert(std::minmax(a, b)).second) return true;
  }
  return false;
}

/// The rims that a cut has left on a piece: where each goes on, in the order in which a lid turns.
std::map<std::uint32_t, std::uint32_t> cut_rims(const Piece& piece, const OpenedSeams& opened,
                                                std::span<const CutMesh::Chain> chains) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::set<Edge> seams;
  std::vector<bool> on_seam(opened.lists.points.size(), false);  // old numbers
  for (const CutMesh::Chain& chain : chains) {
    const std::size_t n = chain.vertices.size();
    for (const std::uint32_t v : chain.vertices) on_seam[v] = true;
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < n; ++i) {
      seams.insert(std::minmax(chain.vertices[i], chain.vertices[(i + 1) % n]));
    }
  }
  const auto old = [&](std::uint32_t v) { return opened.vertex_from[piece.vertices[v]]; };
  std::map<std::uint32_t, std::uint32_t> next;
  for (const Triangle& t : piece.lists.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!on_seam[old(a)] || !on_seam[old(b)]) continue;
      if (seams.count(std::minmax(old(a), old(b))) > 0) next[b] = a;
    }
  }
  return next;
}

}  // namespace

std::vector<Triangle> fill_loop(const std::vector<Point>& points,
                                std::span<const std::uint32_t> loop) {
  std::vector<Triangle> triangles;
  const std::size_t n = loop.size();
  if (n <= kMost) {
    fill_short(points, {loop.begin(), loop.end()}, triangles);
    return triangles;
  }
  Loop spread;
  for (std::size_t k = 0; k < kMost; ++k) {
    const std::size_t from = k * n / kMost, to = (k + 1) * n / kMost;
    spread.push_back(loop[from]);
    Loop stretch;
    for (std::size_t i = from; i <= to; ++i) stretch.push_back(loop[i % n]);
    const auto more = fill_loop(points, stretch);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  fill_short(points, spread, triangles);
  return triangles;
}

Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains) {
  std::map<std::uint32_t, std::uint32_t> next = cut_rims(piece, opened, chains);
  Lids lids;
  std::set<std::uint32_t> starts;  // of rims that are no loops
  for (const auto& [from, to] : next) starts.insert(from);
  for (const auto& [from, to] : next) starts.erase(to);
  lids.left_open = starts.size();
  for (std::uint32_t v : starts) {
    for (auto at = next.find(v); at != next.end(); at = next.find(v)) {
      v = at->second;
      next.erase(at);
    }
  }
  while (!next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(at->first);
      loop.push_back(at->second);
      next.erase(at);
    }
    loop.pop_back();  // where it began
    if (is_slit(loop, [&](std::uint32_t v) { return opened.vertex_from[piece.vertices[v]]; })) {
      ++lids.left_open;
      continue;
    }
    const std::vector<Triangle> lid = fill_loop(piece.lists.points, loop);
    piece.lists.triangles.insert(piece.lists.triangles.end(), lid.begin(), lid.end());
    piece.faces.resize(piece.lists.triangles.size(), kNoFace);
    lids.triangles += lid.size();
    ++lids.filled;
  }
  return lids;
}

}  // namespace talweg

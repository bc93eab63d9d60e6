#include "talweg/core/loop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/plane_filling.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

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

namespace {

/// The closed rims of a piece but for slits; counts the others.
std::vector<Loop> loops_of(const Piece& piece, const OpenedSeams& opened,
                           std::span<const CutMesh::Chain> chains, std::size_t& left_open) {
  std::map<std::uint32_t, std::uint32_t> next = cut_rims(piece, opened, chains);
  std::set<std::uint32_t> starts;  // of rims that are no loops
  for (const auto& [from, to] : next) starts.insert(from);
  for (const auto& [from, to] : next) starts.erase(to);
  left_open = starts.size();
  for (std::uint32_t v : starts) {
    for (auto at = next.find(v); at != next.end(); at = next.find(v)) {
      v = at->second;
      next.erase(at);
    }
  }
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(at->first);
      loop.push_back(at->second);
      next.erase(at);
    }
    loop.pop_back();  // where it began
    if (is_slit(loop, [&](std::uint32_t v) { return opened.vertex_from[piece.vertices[v]]; })) {
      ++left_open;
    } else {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

/// Adds plane lids; returns the loops that have none.
std::vector<std::size_t> fill_planes(const std::vector<Point>& points,
                                     const std::vector<Loop>& loops,
                                     std::vector<Triangle>& triangles) {
  std::vector<bool> done(loops.size(), false);
  const auto fill = [&](const std::vector<std::size_t>& group) {
    std::vector<Loop> own;
    for (const std::size_t i : group) own.push_back(loops[i]);
    const auto lid = fill_plane(points, own);
    if (!lid) return false;
    triangles.insert(triangles.end(), lid->begin(), lid->end());
    for (const std::size_t i : group) done[i] = true;
    return true;
  };
  for (const std::vector<std::size_t>& group : plane_groups(points, loops)) {
    if (fill(group) || group.size() == 1) continue;
    for (const std::size_t i : group) fill({i});
  }
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!done[i]) rest.push_back(i);
  }
  return rest;
}

[[noreturn]] void refuse(const std::vector<Point>& points, const Loop& loop) {
  const Point& at = points[loop[0]];
  const std::string rim = fmt::format("The rim of {} points at ({:.6g}, {:.6g}, {:.6g})",
                                      loop.size(), at.x(), at.y(), at.z());
  const double distance = distance_from_plane(points, loop);
  if (distance <= kPlaneTolerance) {
    throw Error(ErrorCode::kBadCurve,
                rim + " is plane but touches or crosses itself, so no plane lid fits it.");
  }
  throw Error(
      ErrorCode::kBadCurve,
      rim + fmt::format(" is not plane: its points lie up to {:.2g} of its extent off.", distance));
}

}  // namespace

Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind) {
  Lids lids;
  const std::vector<Point>& points = piece.lists.points;
  const std::vector<Loop> loops = loops_of(piece, opened, chains, lids.left_open);
  std::vector<Triangle> triangles;
  std::vector<std::size_t> rest(loops.size());
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  if (kind != LidKind::kLeastArea) rest = fill_planes(points, loops, triangles);
  if (kind == LidKind::kPlanar && !rest.empty()) refuse(points, loops[rest[0]]);
  for (const std::size_t i : rest) {
    const std::vector<Triangle> lid = fill_loop(points, loops[i]);
    triangles.insert(triangles.end(), lid.begin(), lid.end());
  }
  lids.filled = loops.size();
  lids.planar = loops.size() - rest.size();
  lids.triangles = triangles.size();
  piece.lists.triangles.insert(piece.lists.triangles.end(), triangles.begin(), triangles.end());
  piece.faces.resize(piece.lists.triangles.size(), kNoFace);
  return lids;
}

}  // namespace talweg

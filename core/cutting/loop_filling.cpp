#include "talweg/core/cutting/loop_filling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "talweg/core/cutting/lid_choice.hpp"
#include "talweg/core/cutting/lid_clearance.hpp"
#include "talweg/core/cutting/plane_filling.hpp"

namespace talweg {
namespace {

constexpr std::size_t kMost = 256;

/// The area of a triangle, plus a small term for long sides, which decides between triangulations
/// of a plane polygon.
double cost(const Point& a, const Point& b, const Point& c) {
  constexpr double kShape = 1e-6;
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return (b - a).cross(c - a).norm() / 2 + kShape * sides;
}

/// Triangulates by dynamic programming over stretches of the polygon; false if there is no
/// triangulation.
bool fill_short(const std::vector<Point>& points, const Loop& loop, const LeftOut* left_out,
                std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  if (n < 3) return true;
  std::vector<double> least(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t width = 2; width < n; ++width) {
    for (std::size_t i = 0; i + width < n; ++i) {
      if (left_out != nullptr && left_out->poller != nullptr)
        left_out->poller->add_work(width / 8 + 1);
      const std::size_t k = i + width;
      double best = HUGE_VAL;
      const bool is_side = width + 1 == n;
      const bool out = left_out != nullptr && !is_side && left_out->chord(loop[i], loop[k]);
      for (std::size_t j = i + 1; j < k && !out; ++j) {
        const double sum = least[i * n + j] + least[j * n + k] +
                           cost(points[loop[i]], points[loop[j]], points[loop[k]]);
        if (sum >= best) continue;
        if (left_out != nullptr && left_out->has({loop[i], loop[j], loop[k]})) continue;
        best = sum;
        apex[i * n + k] = static_cast<std::uint32_t>(j);
      }
      least[i * n + k] = best;
    }
  }
  if (!(least[n - 1] < HUGE_VAL)) return false;
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
  return true;
}

/// Triangulates a polygon; in a long polygon first its short stretches, then the polygon of their
/// ends.
void fill(const std::vector<Point>& points, std::span<const std::uint32_t> loop,
          std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  if (n <= kMost) {
    fill_short(points, {loop.begin(), loop.end()}, nullptr, triangles);
    return;
  }
  Loop spread;
  for (std::size_t k = 0; k < kMost; ++k) {
    const std::size_t from = k * n / kMost, to = (k + 1) * n / kMost;
    spread.push_back(loop[from]);
    Loop stretch;
    for (std::size_t i = from; i <= to; ++i) stretch.push_back(loop[i % n]);
    fill(points, stretch, triangles);
  }
  fill_short(points, spread, nullptr, triangles);
}

/// fill() without excluded sides and triangles: a stretch is shortened until it can be
/// triangulated.
bool fill_without(const std::vector<Point>& points, std::span<const std::uint32_t> loop,
                  const LeftOut& left_out, std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size(), whole = std::max(left_out.whole, kMost);
  if (n <= whole) return fill_short(points, {loop.begin(), loop.end()}, &left_out, triangles);
  const std::size_t step = (n + kMost - 1) / kMost;
  if (step > whole) return false;
  Loop spread;
  for (std::size_t from = 0; from < n;) {
    spread.push_back(loop[from]);
    std::size_t to = std::min(n, from + step);
    for (; to > from + 1; --to) {  // a side to the next point is always allowed
      if (left_out.chord(loop[from], loop[to % n])) continue;
      Loop stretch;
      for (std::size_t i = from; i <= to; ++i) stretch.push_back(loop[i % n]);
      if (fill_short(points, stretch, &left_out, triangles)) break;
    }
    from = to;
  }
  return spread.size() <= whole && fill_short(points, spread, &left_out, triangles);
}

/// Whether the loop runs along both sides of one seam, so that a lid would have no area.
template <class Original>
bool is_slit(const Loop& loop, const Original& original) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = original(loop[i]), b = original(loop[(i + 1) % loop.size()]);
    if (!edges.insert(std::minmax(a, b)).second) return true;
  }
  return false;
}

/// Per vertex on a rim that a cut left on a piece, the next vertex in the direction of the lid.
std::map<std::uint32_t, std::uint32_t> cut_rims(const Piece& piece, const OpenedSeams& opened,
                                                std::span<const CutMesh::Chain> chains) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::set<Edge> seams;
  std::vector<bool> on_seam(opened.lists.points.size(), false);  // by vertex of the cut mesh
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
  fill(points, loop, triangles);
  return triangles;
}

std::optional<std::vector<Triangle>> fill_loop(const std::vector<Point>& points,
                                               std::span<const std::uint32_t> loop,
                                               const LeftOut& left_out) {
  std::vector<Triangle> triangles;
  if (!fill_without(points, loop, left_out, triangles)) return std::nullopt;
  return triangles;
}

namespace {

/// The closed rims of a piece, without slits. `left_open` receives the number of other rims.
std::vector<Loop> loops_of(const Piece& piece, const OpenedSeams& opened,
                           std::span<const CutMesh::Chain> chains, std::size_t& left_open) {
  std::map<std::uint32_t, std::uint32_t> next = cut_rims(piece, opened, chains);
  std::set<std::uint32_t> starts;  // of open rims
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
    loop.pop_back();  // the first vertex, repeated
    if (is_slit(loop, [&](std::uint32_t v) { return opened.vertex_from[piece.vertices[v]]; })) {
      ++left_open;
    } else {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

/// Groups of rims that share a lid.
std::vector<std::vector<Loop>> groups_of(const std::vector<Point>& points,
                                         const std::vector<Loop>& loops, LidKind kind) {
  std::vector<std::vector<Loop>> groups;
  std::vector<bool> done(loops.size(), false);
  const auto add = [&](const std::vector<std::size_t>& group) {
    std::vector<Loop>& own = groups.emplace_back();
    for (const std::size_t i : group) {
      own.push_back(loops[i]);
      done[i] = true;
    }
  };
  if (kind != LidKind::kLeastArea) {
    for (const std::vector<std::size_t>& group : plane_groups(points, loops)) {
      if (group.size() > 1) {
        std::vector<Loop> own;
        own.reserve(group.size());
        for (const std::size_t i : group) own.push_back(loops[i]);
        if (!fill_plane(points, own)) continue;  // rims that touch get separate lids
      }
      add(group);
    }
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!done[i]) add({i});
  }
  return groups;
}

std::vector<std::uint32_t> parts_of(const Piece& piece, const OpenedSeams& opened) {
  std::vector<std::uint32_t> parts;
  parts.reserve(piece.faces.size());
  for (const std::uint32_t f : piece.faces) parts.push_back(opened.piece_of_face[f]);
  return parts;
}

/// Appends a lid's triangles and inner points to the piece.
void append(const Lid& lid, std::uint32_t first_inner, Piece& piece) {
  const auto shift = static_cast<std::uint32_t>(piece.lists.points.size()) - first_inner;
  for (Triangle t : lid.triangles) {
    for (std::uint32_t& v : t) v += v < first_inner ? 0 : shift;
    piece.lists.triangles.push_back(t);
  }
  piece.lists.points.insert(piece.lists.points.end(), lid.inner.begin(), lid.inner.end());
  piece.vertices.resize(piece.lists.points.size(), kNoVertex);
  piece.faces.resize(piece.lists.triangles.size(), kNoFace);
}

}  // namespace

Lids add_lids(Piece& piece, const OpenedSeams& opened, std::span<const CutMesh::Chain> chains,
              LidKind kind, const Progress& progress) {
  ProgressPoller poller(progress, "cap");
  Lids lids;
  const std::vector<Loop> loops = loops_of(piece, opened, chains, lids.left_open);
  if (loops.empty()) return lids;
  const auto old = [&](std::uint32_t v) { return opened.vertex_from[piece.vertices[v]]; };
  const std::vector<std::uint32_t> parts = parts_of(piece, opened);
  LidClearance clearance(piece.lists, parts, loops, poller);
  LidChooser chooser(piece.lists.points, clearance, old, chains, poller);
  std::vector<Lid> chosen;
  for (const std::vector<Loop>& rims : groups_of(piece.lists.points, loops, kind)) {
    poller.set_fraction(static_cast<double>(lids.filled) / static_cast<double>(loops.size()));
    const Lid& lid = chosen.emplace_back(chooser.choose(rims, kind));
    lids.filled += rims.size();
    lids.planar += lid.plane ? rims.size() : 0;
    lids.triangles += lid.triangles.size();
    lids.inner += lid.inner.size();
    lids.with_inner += lid.inner.empty() ? 0 : rims.size();
    lids.sunk_by = std::max(lids.sunk_by, lid.sunk_by);
  }
  const std::uint32_t first_inner = clearance.first_inner();
  for (const Lid& lid : chosen) append(lid, first_inner, piece);
  return lids;
}

}  // namespace talweg

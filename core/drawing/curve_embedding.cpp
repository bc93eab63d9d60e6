#include "talweg/core/drawing/curve_embedding.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/point_insertion.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

[[noreturn]] void refuse_curve(const std::string& message) {
  throw Error(ErrorCode::kBadCurve, message);
}

std::string name(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return "vertex " + std::to_string(v->vertex.index());
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return "a point on edge " + std::to_string(e->edge.index());
  }
  return "a point in face " + std::to_string(std::get<InFace>(point.where()).face.index());
}

double length_of(const SignpostTriangulation& t, std::span<const HalfedgeId> path) {
  double length = 0;
  for (const HalfedgeId h : path) length += t.surface_length(edge_of(h));
  return length;
}

/// Whether a part of a path is longer than two other parts together. The sum over a part stops once
/// the answer is known, so that short loops cost little.
bool is_longer(const SignpostTriangulation& t, std::span<const HalfedgeId> part,
               std::span<const HalfedgeId> before, std::span<const HalfedgeId> after) {
  const double length = length_of(t, part);
  double sum = 0;
  for (const std::span<const HalfedgeId> other : {before, after}) {
    double own = 0;
    for (std::size_t i = 0; i < other.size() && own < length; ++i)
      own += t.surface_length(edge_of(other[i]));
    sum += own;
  }
  return length > sum;
}

/// Removes loops from a path: the part between two passages of one vertex. Of a closed path, which
/// two passages divide into two loops, the shorter loop is removed. O(n log n) for n halfedges.
void erase_loops(const SignpostTriangulation& t, std::vector<HalfedgeId>& path, bool closed) {
  std::vector<HalfedgeId> kept;
  std::map<VertexId, std::size_t> passed;  // vertex, and number of halfedges kept before it
  for (std::size_t i = 0; i < path.size(); ++i) {
    const HalfedgeId h = path[i];
    passed.emplace(t.tail(h), kept.size());
    kept.push_back(h);
    const auto again = passed.find(t.head(h));
    if (again == passed.end()) continue;
    const std::size_t from = again->second;
    if (closed && from == 0 && i + 1 == path.size()) break;  // the path closes here
    const std::span<const HalfedgeId> all(kept);
    if (closed &&
        is_longer(t, all.subspan(from), all.first(from), std::span(path).subspan(i + 1))) {
      kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(from));
      break;
    }
    for (const HalfedgeId gone : all.subspan(from)) passed.erase(t.tail(gone));
    kept.resize(from);
  }
  path = std::move(kept);
}

}  // namespace

void check_drawn(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t count = curve.points.size();
  const std::size_t least = curve.closed ? 3 : 2;
  if (count < least) {
    refuse_curve(std::string(curve.closed ? "A closed" : "An open") + " curve needs at least " +
                 std::to_string(least) + " different points, but this one has " +
                 std::to_string(count) + ".");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (next == 0 && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[next];
    if (common_face(surface, p, q).valid()) continue;
    refuse_curve("Points " + std::to_string(i + 1) + " and " + std::to_string(next + 1) +
                 " of the curve (" + name(p) + " and " + name(q) +
                 ") do not lie in a common face.");
  }
}

EmbeddedCurves embed_curves(SignpostTriangulation& triangulation,
                            std::span<const SurfaceCurve> curves,
                            std::span<const SurfacePoint> pins, Loops loops,
                            std::span<const std::size_t> names, const Progress& progress) {
  constexpr std::size_t kOfPoint = 32;  // units of work
  ProgressPoller poller(progress, "embed");
  PointInsertion insertion(triangulation);
  EmbeddedCurves embedded;
  const PointLookup pinned(pins);
  std::vector<std::vector<VertexId>> vertices(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const SurfacePoint& point : curves[c].points) {
      poller.add_work(kOfPoint);
      const VertexId v = insertion.insert(point);
      // Between slivers, inserting a point a second time may give another vertex.
      if (pinned.contains(point)) embedded.pinned.push_back(v);
      if (vertices[c].empty() || vertices[c].back() != v) vertices[c].push_back(v);
    }
    if (curves[c].closed && vertices[c].size() > 1 && vertices[c].front() == vertices[c].back()) {
      vertices[c].pop_back();
    }
  }
  // The connection of one pair of vertices may split edges of another pair's connection, so the
  // chains are read after all pairs are connected.
  struct Joined {
    std::size_t curve, since;
    std::vector<HalfedgeId> way;
  };
  std::vector<Joined> joined;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::size_t count = vertices[c].size();
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < count; ++i) {
      poller.add_work(kOfPoint);
      std::vector<HalfedgeId> way;
      insertion.connect(vertices[c][i], vertices[c][(i + 1) % count], way);
      joined.push_back({c, insertion.split_count(), std::move(way)});
    }
  }
  std::vector<std::vector<HalfedgeId>> chains(curves.size());
  for (const Joined& pair : joined) {
    poller.add_work(kOfPoint / 4);
    const std::vector<HalfedgeId> now = insertion.with_splits(pair.way, pair.since);
    chains[pair.curve].insert(chains[pair.curve].end(), now.begin(), now.end());
  }
  std::sort(embedded.pinned.begin(), embedded.pinned.end());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (loops == Loops::kErase) erase_loops(triangulation, chains[c], curves[c].closed);
    if (chains[c].size() < (curves[c].closed ? 3U : 1U)) {
      refuse_curve(
          "Curve " + std::to_string(names.empty() ? c : names[c]) +
          " comes back to where it began without going around anything: its points are too "
          "close together, or it goes back the way it came.");
    }
    embedded.paths.push_back(EdgePath::make(triangulation, std::move(chains[c]), curves[c].closed));
  }
  return embedded;
}

}  // namespace talweg

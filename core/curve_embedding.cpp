#include "talweg/core/curve_embedding.hpp"

#include <algorithm>
#include <string>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/point_insertion.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_curve(const std::string& message) {
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

/// A total order that puts equal points side by side.
std::array<double, 5> sort_key(const SurfacePoint& point) {
  const auto number = [](std::size_t n) { return static_cast<double>(n); };
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return {0, number(v->vertex.index())};
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return {1, number(e->edge.index()), e->t};
  }
  const auto& f = std::get<InFace>(point.where());
  return {2, number(f.face.index()), f.barycentric[0], f.barycentric[1], f.barycentric[2]};
}

void check_repeats(const SurfaceCurve& curve) {
  std::vector<std::size_t> order(curve.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto p = sort_key(curve.points[a]), q = sort_key(curve.points[b]);
    return p != q ? p < q : a < b;
  });
  std::size_t first = order.size(), second = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (curve.points[order[i]] == curve.points[order[i + 1]] && order[i] < first) {
      first = order[i];
      second = order[i + 1];
    }
  }
  if (first < order.size()) {
    bad_curve("The curve passes " + name(curve.points[first]) + " twice, at its points " +
              std::to_string(first + 1) + " and " + std::to_string(second + 1) + ".");
  }
}

void check_no_vertex_twice(const SignpostTriangulation& triangulation,
                           std::span<const HalfedgeId> path, bool closed) {
  std::vector<VertexId> passed;
  for (const HalfedgeId h : path) passed.push_back(triangulation.tail(h));
  if (!closed) passed.push_back(triangulation.head(path.back()));
  std::sort(passed.begin(), passed.end());
  const auto twice = std::adjacent_find(passed.begin(), passed.end());
  if (twice != passed.end()) {
    bad_curve("The curve crosses or touches itself at " + name(triangulation.location(*twice)) +
              ".");
  }
}

}  // namespace

void check_drawn(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t count = curve.points.size();
  const std::size_t least = curve.closed ? 3 : 2;
  if (count < least) {
    bad_curve(std::string(curve.closed ? "A closed" : "An open") + " curve needs at least " +
              std::to_string(least) + " different points, but this one has " +
              std::to_string(count) + ".");
  }
  check_repeats(curve);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (next == 0 && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[next];
    if (common_face(surface, p, q).valid()) continue;
    bad_curve("Points " + std::to_string(i + 1) + " and " + std::to_string(next + 1) +
              " of the curve (" + name(p) + " and " + name(q) + ") do not lie in a common face.");
  }
}

EmbeddedCurves embed_curves(SignpostTriangulation& triangulation,
                            std::span<const SurfaceCurve> curves,
                            std::span<const SurfacePoint> pins) {
  PointInsertion insertion(triangulation);
  std::vector<std::vector<VertexId>> vertices(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const SurfacePoint& point : curves[c].points) {
      const VertexId v = insertion.insert(point);
      if (vertices[c].empty() || vertices[c].back() != v) vertices[c].push_back(v);
    }
    if (curves[c].closed && vertices[c].size() > 1 && vertices[c].front() == vertices[c].back()) {
      vertices[c].pop_back();
    }
  }
  // Joining one pair may split an edge that another pair runs along, so the chains are read off
  // only when all are joined.
  struct Joined {
    std::size_t curve, since;
    std::vector<HalfedgeId> way;
  };
  std::vector<Joined> joined;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::size_t count = vertices[c].size();
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < count; ++i) {
      std::vector<HalfedgeId> way;
      insertion.connect(vertices[c][i], vertices[c][(i + 1) % count], way);
      joined.push_back({c, insertion.split_count(), std::move(way)});
    }
  }
  std::vector<std::vector<HalfedgeId>> chains(curves.size());
  for (const Joined& pair : joined) {
    const std::vector<HalfedgeId> now = insertion.now(pair.way, pair.since);
    chains[pair.curve].insert(chains[pair.curve].end(), now.begin(), now.end());
  }
  EmbeddedCurves embedded;
  for (const SurfacePoint& pin : pins) embedded.pinned.push_back(insertion.insert(pin));
  std::sort(embedded.pinned.begin(), embedded.pinned.end());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (chains[c].size() < (curves[c].closed ? 3U : 1U)) {
      bad_curve("The curve's points are too close together to be told apart.");
    }
    check_no_vertex_twice(triangulation, chains[c], curves[c].closed);
    embedded.paths.push_back(EdgePath::make(triangulation, std::move(chains[c]), curves[c].closed));
  }
  return embedded;
}

}  // namespace talweg

// Paths, random flips, and measures that do not use signposts, for the tests of the intrinsic
// layer.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::test {

// ---- paths ----

inline std::vector<HalfedgeId> halfedges_through(const SignpostTriangulation& t,
                                                 const std::vector<std::size_t>& vertices,
                                                 bool closed = false) {
  std::vector<HalfedgeId> path;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < vertices.size(); ++i) {
    path.push_back(
        t.find_halfedge(VertexId{vertices[i]}, VertexId{vertices[(i + 1) % vertices.size()]}));
  }
  return path;
}

inline EdgePath path_through(const SignpostTriangulation& t,
                             const std::vector<std::size_t>& vertices, bool closed = false) {
  return EdgePath::make(t, halfedges_through(t, vertices, closed), closed);
}

/// The vertices of a shortest path along edges (Dijkstra).
inline std::vector<std::size_t> shortest_vertices(const Surface& s, std::size_t from,
                                                  std::size_t to) {
  std::vector<double> best(s.vertex_count(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> parent(s.vertex_count(), from);
  std::set<std::pair<double, std::size_t>> queue = {{0, from}};
  best[from] = 0;
  while (!queue.empty()) {
    const auto [d, v] = *queue.begin();
    queue.erase(queue.begin());
    if (v == to) break;
    const HalfedgeId first = s.halfedge(VertexId{v});
    HalfedgeId h = first;
    do {
      const std::size_t w = s.head(h).index();
      const double length = d + s.length(edge_of(h));
      if (length < best[w]) {
        queue.erase({best[w], w});
        best[w] = length;
        parent[w] = v;
        queue.insert({length, w});
      }
      if (!s.has_face(h)) break;
      h = s.turn_ccw(h);
    } while (h != first);
  }
  std::vector<std::size_t> path = {to};
  while (path.back() != from) path.push_back(parent[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

/// A random walk of up to `steps` edges; empty at an isolated vertex.
inline std::vector<HalfedgeId> random_walk(SignpostTriangulation& t, Random& random,
                                           std::size_t steps) {
  std::vector<HalfedgeId> path;
  VertexId v{random.below(t.vertex_count())};
  for (std::size_t k = 0; k < steps; ++k) {
    std::vector<HalfedgeId> spokes;
    const HalfedgeId first = t.halfedge(v);
    if (!first.valid()) return path;
    HalfedgeId h = first;
    do {
      spokes.push_back(h);
      if (!t.has_face(h)) break;
      h = t.turn_ccw(h);
    } while (h != first);
    path.push_back(spokes[random.below(spokes.size())]);
    v = t.head(path.back());
  }
  return path;
}

/// A random walk that meets no vertex twice; ends early if it is trapped.
inline std::vector<HalfedgeId> self_avoiding_walk(SignpostTriangulation& t, Random& random,
                                                  std::size_t steps) {
  std::vector<HalfedgeId> path;
  VertexId v{random.below(t.vertex_count())};
  std::set<VertexId> met = {v};
  for (std::size_t k = 0; k < steps; ++k) {
    std::vector<HalfedgeId> spokes;
    const HalfedgeId first = t.halfedge(v);
    HalfedgeId h = first;
    do {
      if (!met.contains(t.head(h))) spokes.push_back(h);
      if (!t.has_face(h)) break;
      h = t.turn_ccw(h);
    } while (h != first);
    if (spokes.empty()) break;
    path.push_back(spokes[random.below(spokes.size())]);
    v = t.head(path.back());
    met.insert(v);
  }
  return path;
}

// ---- measures that do not use signposts ----

/// The angle from one outgoing halfedge counterclockwise to another, summed over corners; +infinity
/// across the boundary; the whole cone angle for equal halfedges.
inline double corner_sum(SignpostTriangulation& t, HalfedgeId from, HalfedgeId to) {
  double sum = 0;
  do {
    if (!t.has_face(from)) return std::numeric_limits<double>::infinity();
    sum += t.corner_angle(from);
    from = t.turn_ccw(from);
  } while (from != to);
  return sum;
}

/// The smaller side angle at every joint of a path, summed over corners; 0 at spikes.
inline std::vector<double> side_angles(SignpostTriangulation& t, const EdgePath& path) {
  std::vector<double> angles;
  const auto h = path.halfedges();
  for (std::size_t i = 0; i + (path.closed() ? 0 : 1) < h.size(); ++i) {
    const HalfedgeId into = twin(h[i]), onward = h[(i + 1) % h.size()];
    angles.push_back(
        into == onward ? 0 : std::min(corner_sum(t, into, onward), corner_sum(t, onward, into)));
  }
  return angles;
}

/// The position of a point of a simplicial surface, from the positions of the vertices.
inline Point position(const Surface& surface, const std::vector<Point>& points,
                      const SurfacePoint& p) {
  if (const auto* v = std::get_if<AtVertex>(&p.where())) return points[v->vertex.index()];
  const FaceId face = any_face(surface, p);
  const auto weights = coordinates_in(surface, p, face).barycentric;
  const auto corners = surface.corners(face);
  Point sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t x = 0; x < 3; ++x) sum[x] += weights[k] * points[corners[k].index()][x];
  }
  return sum;
}

inline double length_of(const Surface& surface, const std::vector<Point>& points,
                        const SurfaceCurve& curve) {
  double length = 0;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    length += distance(position(surface, points, curve.points[i]),
                       position(surface, points, curve.points[(i + 1) % n]));
  }
  return length;
}

/// Whether each point and the next lie in one face.
inline bool runs_in_faces(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (!common_face(surface, curve.points[i], curve.points[(i + 1) % n]).valid()) return false;
  }
  return n > 0;
}

/// The state of a triangulation, for bitwise comparison.
struct Snapshot {
  std::vector<std::size_t> connectivity;
  std::vector<double> numbers;
  friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

inline Snapshot snapshot(SignpostTriangulation& t) {
  Snapshot s;
  for (std::size_t v = 0; v < t.vertex_count(); ++v) {
    s.connectivity.push_back(t.halfedge(VertexId{v}).index());
    s.numbers.push_back(t.cone_angle(VertexId{v}));
  }
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    const HalfedgeId h{i};
    s.connectivity.push_back(t.next(h).index());
    s.connectivity.push_back(t.tail(h).index());
    s.connectivity.push_back(t.surface_face(h).index());
    s.numbers.push_back(t.length(h));
    // The direction of a halfedge relative to the vertex's own halfedge.
    if (t.halfedge(t.tail(h)).valid()) s.numbers.push_back(t.angle_ccw(t.halfedge(t.tail(h)), h));
  }
  return s;
}

inline std::size_t flip_at_random(SignpostTriangulation& t, Random& random, std::size_t tries) {
  std::size_t flips = 0;
  for (std::size_t k = 0; k < tries; ++k) {
    flips += t.flip(EdgeId{random.below(t.edge_count())}) ? 1 : 0;
  }
  return flips;
}

/// Random flips that leave no angle below `smallest`. The angles of a triangle give its sides only
/// to an error of ulp / angle, so unbounded flips would measure only that error.
inline std::size_t flip_fat(SignpostTriangulation& t, Random& random, std::size_t tries,
                            double smallest) {
  std::size_t flips = 0;
  for (std::size_t k = 0; k < tries; ++k) {
    const EdgeId e{random.below(t.edge_count())};
    if (!t.flip(e)) continue;
    double least = kPi;
    for (const HalfedgeId h : {halfedge_of(e), twin(halfedge_of(e))}) {
      for (const HalfedgeId side : {h, t.next(h), t.prev(h)}) {
        least = std::min(least, t.corner_angle(side));
      }
    }
    if (least < smallest) {
      t.undo_flip();
    } else {
      ++flips;
    }
  }
  return flips;
}

}  // namespace talweg::test

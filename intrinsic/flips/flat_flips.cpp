#include "talweg/intrinsic/flips/flat_flips.hpp"

#include <cmath>
#include <deque>
#include <numbers>

#include "talweg/intrinsic/surface/surface_point.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

std::array<double, 3> weights_in(const SignpostTriangulation& triangulation, VertexId v,
                                 FaceId face) {
  return coordinates_in(triangulation.surface(), triangulation.location(v), face).barycentric;
}

bool FlatFlips::is_inside(HalfedgeId h) const {
  const SignpostTriangulation& t = *triangulation_;
  return edge_of(h).index() >= t.surface().edge_count() && t.has_face(h) && t.has_face(twin(h)) &&
         t.surface_face(h) == t.surface_face(twin(h));
}

/// Whether both triangles have an area after the flip.
bool FlatFlips::is_convex(HalfedgeId h) const {
  constexpr double kFlat = 1e-12;
  const SignpostTriangulation& t = *triangulation_;
  const FaceId face = t.surface_face(h);
  const Weights c = weights_in(t, t.tail(h), face), d = weights_in(t, t.head(h), face);
  const Weights a = weights_in(t, t.tail(t.prev(h)), face);
  const Weights b = weights_in(t, t.tail(t.prev(twin(h))), face);
  const double size = std::abs(orient(c, d, a)) + std::abs(orient(d, c, b));
  return orient(b, a, c) > kFlat * size && orient(a, b, d) > kFlat * size;
}

/// Whether the two angles opposite the edge sum to at most pi, up to rounding.
bool FlatFlips::is_delaunay(HalfedgeId h) const {
  constexpr double kRounding = 1e-9;
  const SignpostTriangulation& t = *triangulation_;
  double angles = 0;
  for (const HalfedgeId side : {h, twin(h)}) {
    const auto length = [&](HalfedgeId k) { return t.surface_length(edge_of(k)); };
    angles += angle_between(length(t.next(side)), length(t.prev(side)), length(side));
  }
  return angles <= std::numbers::pi + kRounding;
}

void FlatFlips::flip(HalfedgeId h) {
  SignpostTriangulation& t = *triangulation_;
  const FaceId face = t.surface_face(h);
  const FaceCoordinates a{face, weights_in(t, t.tail(t.prev(h)), face)};
  const FaceCoordinates b{face, weights_in(t, t.tail(t.prev(twin(h))), face)};
  before_(h);
  t.flip_unlogged(edge_of(h), distance_in_face(t.surface(), a, b));
}

void FlatFlips::improve(std::vector<HalfedgeId> edges) {
  const SignpostTriangulation& t = *triangulation_;
  // Lawson's flips end in exact arithmetic; the limit guards against rounding.
  for (std::size_t left = 10000 + 64 * edges.size(); !edges.empty() && left > 0; --left) {
    const HalfedgeId h = edges.back();
    edges.pop_back();
    if (!is_inside(h) || is_fixed(edge_of(h)) || is_delaunay(h) || !is_convex(h)) continue;
    edges.insert(edges.end(), {t.next(h), t.prev(h), t.next(twin(h)), t.prev(twin(h))});
    flip(h);
  }
}

FlatFlips::Segment FlatFlips::segment(HalfedgeId h, VertexId to, FaceId face) const {
  const SignpostTriangulation& t = *triangulation_;
  const Weights p = weights_in(t, t.tail(h), face), q = weights_in(t, to, face);
  Segment segment;
  // The limit on crossed edges guards against rounding among slivers.
  for (HalfedgeId e = t.next(h); is_inside(e) && segment.crossed.size() < t.edge_count();) {
    const Weights b = weights_in(t, t.tail(e), face), c = weights_in(t, t.head(e), face);
    if (is_fixed(edge_of(e))) {
      const double right_of = orient(p, b, q), left_of = orient(p, q, c);
      segment.stop = e;
      segment.part = right_of / (right_of + left_of);
      break;
    }
    segment.crossed.push_back(e);
    const HalfedgeId back = twin(e);
    const VertexId beyond = t.tail(t.prev(back));
    const Weights o = weights_in(t, beyond, face);
    const double left = orient(p, q, o);
    if (beyond == to || std::abs(left) <= kOnSide * std::abs(orient(p, b, o) - orient(p, c, o))) {
      segment.end = beyond;
      break;
    }
    e = left > 0 ? t.next(back) : t.prev(back);
  }
  return segment;
}

HalfedgeId FlatFlips::clear(const Segment& segment, VertexId from, VertexId to, FaceId face) {
  const SignpostTriangulation& t = *triangulation_;
  const Weights p = weights_in(t, from, face), q = weights_in(t, to, face);
  const auto left_of = [&](VertexId v) { return orient(p, q, weights_in(t, v, face)) > 0; };
  std::deque<HalfedgeId> crossed(segment.crossed.begin(), segment.crossed.end());
  std::vector<HalfedgeId> turned;
  // Sloan's bound on the number of flips; rounding among slivers might repeat flips without end.
  std::size_t left = (crossed.size() + 2) * (crossed.size() + 2);
  for (std::size_t stuck = 0; !crossed.empty(); --left) {
    if (left == 0) return {};
    const HalfedgeId h = crossed.front();
    crossed.pop_front();
    if (!is_convex(h)) {
      crossed.push_back(h);
      if (++stuck > crossed.size()) return {};
      continue;
    }
    stuck = 0;
    flip(h);
    const VertexId a = t.tail(h), b = t.head(h);
    const bool at_end = a == from || b == from || a == to || b == to;
    if (!at_end && left_of(a) != left_of(b)) {
      crossed.push_back(h);
    } else {
      turned.push_back(h);
    }
  }
  const HalfedgeId joined = t.find_halfedge(from, to);
  if (!joined.valid()) return {};
  fix(edge_of(joined));
  improve(std::move(turned));
  return joined;
}

}  // namespace talweg

#include "talweg/core/fairing/curve_trace.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {

HalfedgeId outgoing(const Surface& surface, FaceId face, VertexId v) {
  HalfedgeId h = surface.halfedge(face);
  while (surface.tail(h) != v) h = surface.next(h);
  return h;
}

namespace {

/// The common face of two points; invalid if there is none. For two points on one edge, the left
/// face, so that the result does not depend on the numbers of faces.
FaceId face_of(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q) {
  const FaceId face = common_face(surface, p, q);
  if (!face.valid()) return face;
  const auto from = coordinates_in(surface, p, face).barycentric;
  const auto to = coordinates_in(surface, q, face).barycentric;
  HalfedgeId side = surface.halfedge(face);  // from corner 0 to corner 1
  for (std::size_t k = 0; k < 3; ++k, side = surface.next(side)) {
    const std::size_t next = (k + 1) % 3, opposite = (k + 2) % 3;
    if (from[opposite] != 0 || to[opposite] != 0) continue;
    const bool forwards = to[next] >= from[next];
    return forwards || !surface.has_face(twin(side)) ? face : surface.face(twin(side));
  }
  return face;
}

}  // namespace

FaceStrip faces_around(const Surface& surface, FaceId from, FaceId to, VertexId v, bool left) {
  FaceStrip strip;
  HalfedgeId h = outgoing(surface, from, v);
  if (left) h = surface.prev(h);
  for (FaceId face = from; face != to;) {
    if (!surface.has_face(twin(h))) return {};
    strip.push_back(h);
    face = surface.face(twin(h));
    h = left ? surface.prev(twin(h)) : surface.next(twin(h));
  }
  return strip;
}

void cross_at(const Surface& surface, const SurfacePoint& point, FaceId from, FaceId to,
              FaceStrip& crossed) {
  if (from == to) return;
  if (const auto* on_edge = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(on_edge->edge);
    crossed.push_back(surface.face(h) == from ? h : twin(h));
    return;
  }
  const VertexId v = std::get<AtVertex>(point.where()).vertex;
  const FaceStrip left = faces_around(surface, from, to, v, true);
  const FaceStrip right = faces_around(surface, from, to, v, false);
  const bool go_left = right.empty() || (!left.empty() && left.size() < right.size());
  const FaceStrip& way = go_left ? left : right;
  crossed.insert(crossed.end(), way.begin(), way.end());
}

void CurveTrace::add(const CurveSegment& segment) {
  pieces.push_back({segment, length, static_cast<std::uint32_t>(crossed.size())});
  length += segment.length;
}

void CurveTrace::set_corners(std::span<const SurfacePoint> points) {
  if (points.empty()) return;
  corners.clear();
  const PointLookup at_corner(points);
  for (const SurfacePoint& point : fixed_points) {
    corners.push_back(at_corner.contains(point));
  }
}

void CurveTrace::set_drawn() {
  drawn.clear();
  for (const TracePiece& piece : pieces) drawn.push_back(piece.arc);
  drawn.push_back(length);
}

double CurveTrace::drawn_at(std::size_t piece, double arc) const {
  const TracePiece& p = pieces[piece];
  const double part = p.length > 0 ? std::clamp((arc - p.arc) / p.length, 0.0, 1.0) : 0;
  return drawn[piece] + part * (drawn[piece + 1] - drawn[piece]);
}

std::vector<double> CurveTrace::stretch_lengths() const {
  std::vector<double> arcs;
  if (!closed) arcs.push_back(0);
  for (const std::size_t piece : fixed) arcs.push_back(pieces[piece].arc);
  if (!closed) arcs.push_back(length);
  if (arcs.empty()) return {length};
  if (closed) arcs.push_back(arcs.front() + length);
  std::vector<double> lengths;
  for (std::size_t k = 0; k + 1 < arcs.size(); ++k) lengths.push_back(arcs[k + 1] - arcs[k]);
  return lengths;
}

std::size_t CurveTrace::piece_at(double arc) const {
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), arc,
                                      [](double a, const TracePiece& p) { return a < p.arc; });
  return after == pieces.begin() ? 0 : static_cast<std::size_t>(after - pieces.begin()) - 1;
}

FaceCoordinates CurveTrace::point(std::size_t piece, double arc) const {
  const TracePiece& p = pieces[piece];
  // The end of the curve is exact, in spite of rounding of its arc length.
  const double part = arc >= length && piece + 1 == pieces.size() ? 1
                      : p.length > 0 ? std::clamp((arc - p.arc) / p.length, 0.0, 1.0)
                                     : 0;
  return {p.face, p.at(part)};
}

CurveTrace trace_of(const Surface& surface, const SurfaceCurve& curve,
                    std::span<const SurfacePoint> fixed) {
  std::vector<std::size_t> places;
  const PointLookup stays(fixed);
  for (std::size_t i = 0; i < curve.points.size() && !fixed.empty(); ++i) {
    if (stays.contains(curve.points[i])) places.push_back(i);
  }
  return trace_through(surface, curve, places);
}

CurveTrace trace_through(const Surface& surface, const SurfaceCurve& curve,
                         std::span<const std::size_t> fixed) {
  CurveTrace trace;
  trace.closed = curve.closed;
  const std::size_t n = curve.points.size();
  const std::size_t count = n < 2 ? 0 : curve.closed ? n : n - 1;
  if (count > 0 && !curve.closed) trace.fixed_points.push_back(curve.points.front());
  for (std::size_t i = 0; i < count; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    const FaceId face = face_of(surface, p, q);
    if (!face.valid()) {
      throw Error(
          ErrorCode::kBadCurve,
          fmt::format("Points {} and {} of the curve lie in no common face.", i, (i + 1) % n));
    }
    if ((i > 0 || curve.closed) && std::binary_search(fixed.begin(), fixed.end(), i)) {
      trace.fixed.push_back(i);
      trace.fixed_points.push_back(p);
    }
    trace.add(segment_between(surface, p, q, face));
  }
  if (count > 0 && !curve.closed) trace.fixed_points.push_back(curve.points.back());
  for (std::size_t i = 0; i < count; ++i) {
    trace.pieces[i].crossed = static_cast<std::uint32_t>(trace.crossed.size());
    if (i + 1 == count && !curve.closed) break;
    const std::size_t j = (i + 1) % count;
    cross_at(surface, curve.points[(i + 1) % n], trace.pieces[i].face, trace.pieces[j].face,
             trace.crossed);
  }
  return trace;
}

}  // namespace talweg

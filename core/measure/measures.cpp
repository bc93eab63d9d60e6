#include "talweg/core/measure/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

constexpr double kPi = std::numbers::pi;

FaceId shared_face(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q) {
  const FaceId f = common_face(surface, p, q);
  if (!f.valid()) {
    throw Error(ErrorCode::kBadCurve, "Two neighbouring points of the curve share no face.");
  }
  return f;
}

double length_of(const Surface& surface, HalfedgeId h) { return surface.length(edge_of(h)); }

double corner_angle(const Surface& surface, HalfedgeId h) {
  const HalfedgeId next = surface.next(h);
  return angle_between(length_of(surface, h), length_of(surface, surface.next(next)),
                       length_of(surface, next));
}

using Barycentric = std::array<double, 3>;

/// A point of a curve and its next or previous point, in a common face.
struct Side {
  FaceId face;
  Barycentric at{}, other{};
};

Side side_of(const Surface& surface, const SurfacePoint& at, const SurfacePoint& other, FaceId f) {
  return {f, coordinates_in(surface, at, f).barycentric,
          coordinates_in(surface, other, f).barycentric};
}

using Turn = PointTurn;

/// The vector between two points of a face, in the plane where halfedge h of the face lies on the x
/// axis and the face above it.
PlanePoint way(const Surface& surface, HalfedgeId h, const Barycentric& from,
               const Barycentric& to) {
  const HalfedgeId first = surface.halfedge(surface.face(h)), next = surface.next(h);
  const std::size_t k = h == first ? 0 : next == first ? 2 : 1;  // the corner at the tail of h
  const double along = to[(k + 1) % 3] - from[(k + 1) % 3];
  const double across = to[(k + 2) % 3] - from[(k + 2) % 3];
  const double length = length_of(surface, h);
  const PlanePoint top =
      apex(length, length_of(surface, surface.next(next)), length_of(surface, next));
  return {along * length + across * top.x, across * top.y};
}

/// The angle at the tail of halfedge h from h to the other point, in [0, pi].
double angle_from(const Surface& surface, HalfedgeId h, const Side& side) {
  const PlanePoint out = way(surface, h, side.at, side.other);
  return std::atan2(out.y, out.x);
}

/// The turn at a vertex. Directions are angles from the vertex's first halfedge, counterclockwise.
Turn turn_at(const Surface& surface, VertexId v, const Side& before, const Side& after) {
  double in = 0, out = 0, cone = 0;
  const HalfedgeId first = surface.halfedge(v);
  HalfedgeId h = first;
  do {
    if (surface.face(h) == before.face) in = cone + angle_from(surface, h, before);
    if (surface.face(h) == after.face) out = cone + angle_from(surface, h, after);
    cone += corner_angle(surface, h);
    h = surface.turn_ccw(h);
  } while (h != first && surface.has_face(h));
  const double swept = in - out;  // counterclockwise from `out` to `in`
  if (surface.on_boundary(v)) {   // the cone does not close
    const double turn = kPi - std::abs(swept);
    const double inside = std::clamp(turn, 0.0, kPi);
    return {inside, swept > 0 ? turn : -turn, inside};
  }
  const double left = swept < 0 ? swept + cone : swept;
  const double toward_left = cone / 2 - left;
  return {std::clamp(kPi - std::min(left, cone - left), 0.0, kPi), toward_left,
          std::abs(toward_left)};
}

/// The turn at any point. Inside edges and faces, both segments unfold into one plane.
Turn turn_at(const Surface& surface, const SurfacePoint& at, const Side& before,
             const Side& after) {
  if (const auto* v = std::get_if<AtVertex>(&at.where())) {
    return turn_at(surface, v->vertex, before, after);
  }
  const auto* edge = std::get_if<OnEdge>(&at.where());
  HalfedgeId h = surface.halfedge(before.face), beyond = h;
  double sign = 1;
  if (edge != nullptr) {  // both segments in the frame of the edge
    h = halfedge_of(edge->edge);
    if (!surface.has_face(h) || surface.face(h) != before.face) h = twin(h);
    if (before.face != after.face) sign = -1;
    beyond = before.face == after.face ? h : twin(h);
  }
  const PlanePoint in = way(surface, h, before.other, before.at);
  const PlanePoint out = sign * way(surface, beyond, after.at, after.other);
  const double left = std::atan2(cross(in, out), dot(in, out));
  return {std::abs(left), left, std::abs(left)};
}

std::size_t segment_count(const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  return n < 2 ? 0 : curve.closed ? n : n - 1;
}

/// The face of segment i.
FaceId face_of(const Surface& surface, const SurfaceCurve& curve, std::size_t i) {
  const std::size_t j = (i + 1) % curve.points.size();
  const FaceId f = common_face(surface, curve.points[i], curve.points[j]);
  if (!f.valid()) {
    throw Error(ErrorCode::kBadCurve, "Points " + std::to_string(i) + " and " + std::to_string(j) +
                                          " of the curve lie in no common face.");
  }
  return f;
}

Turn turn_at(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
             const SurfacePoint& after) {
  return turn_at(surface, at, side_of(surface, at, before, shared_face(surface, at, before)),
                 side_of(surface, at, after, shared_face(surface, at, after)));
}

/// Segment i, from point i to the next.
Side segment(const Surface& surface, const SurfaceCurve& curve, std::size_t i) {
  const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % curve.points.size()];
  return side_of(surface, p, q, face_of(surface, curve, i));
}

double length(const Surface& surface, const Side& segment) {
  return distance_in_face(surface, {segment.face, segment.at}, {segment.face, segment.other});
}

/// Measures the length and the turning angles of a curve, and lists its turns.
CurveMeasures measure(const Surface& surface, const SurfaceCurve& curve, CurveTurns& turns) {
  CurveMeasures measures;
  const std::size_t n = curve.points.size();
  std::vector<Side> segments;
  std::vector<double> at{0};  // arc length at each point
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    segments.push_back(segment(surface, curve, i));
    at.push_back(at.back() + length(surface, segments.back()));
  }
  measures.length = at.back();
  turns.length = at.back();
  turns.closed = curve.closed;
  if (n < 2) return measures;
  for (std::size_t i = curve.closed ? 0 : 1; i < (curve.closed ? n : n - 1); ++i) {
    const Side& before = segments[i == 0 ? n - 1 : i - 1];
    const Turn turn =
        turn_at(surface, curve.points[i], {before.face, before.other, before.at}, segments[i]);
    measures.total_curvature += turn.angle;
    measures.signed_curvature += turn.toward_left;
    turns.at.push_back(at[i]);
    turns.angle.push_back(turn.toward_left);
    if (turn.from_straight > measures.max_curvature) {
      measures.max_curvature = turn.from_straight;
      measures.max_at = i;
    }
  }
  return measures;
}

/// See CurveMeasures::tortuosity.
double tortuosity(const SurfaceMesh& mesh, const SurfaceCurve& curve, double length) {
  if (curve.closed || curve.points.size() < 2) return HUGE_VAL;
  const double apart =
      (mesh.position(curve.points.back()) - mesh.position(curve.points.front())).norm();
  return apart > 0 ? length / apart : HUGE_VAL;
}

}  // namespace

PointTurn turn_of(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                  const SurfacePoint& after) {
  return turn_at(surface, before, at, after);
}

double turning_angle(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                     const SurfacePoint& after) {
  return turn_at(surface, before, at, after).angle;
}

double signed_turning(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                      const SurfacePoint& after) {
  return turn_at(surface, before, at, after).toward_left;
}

double curve_length(const Surface& surface, const SurfaceCurve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    sum += length(surface, segment(surface, curve, i));
  }
  return sum;
}

CurveTurns turns_of(const Surface& surface, const SurfaceCurve& curve) {
  CurveTurns turns;
  measure(surface, curve, turns);
  return turns;
}

CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve) {
  CurveTurns turns;
  return measure(surface, curve, turns);
}

CurveMeasures measure_curve(const Surface& surface, const SurfaceCurve& curve, double edge) {
  CurveTurns turns;
  CurveMeasures measures = measure(surface, curve, turns);
  measures.bending = bending(turns, edge);
  measures.window_turning = window_turning(turns, edge);
  measures.window_turning_2 = window_turning(turns, 2 * edge);
  return measures;
}

CurveMeasures measure_curve(const SurfaceMesh& mesh, const SurfaceCurve& curve, double edge) {
  CurveMeasures measures = measure_curve(mesh.surface(), curve, edge);
  measures.tortuosity = tortuosity(mesh, curve, measures.length);
  return measures;
}

}  // namespace talweg

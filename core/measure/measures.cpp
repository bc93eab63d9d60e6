#include "talweg/core/measure/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "talweg/core/measure/turning_windows.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

constexpr double kPi = std::numbers::pi;

/// A direction at a point: an angle in [0, cone], counterclockwise, radians.
struct Direction {
  double angle = 0;
  double cone = 2 * kPi;  ///< all angles about the point
  bool open = false;      ///< the point is on the boundary: the cone does not close
};

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

/// The angle from halfedge h to the vector q - p, in [0, pi] when p lies on h. p and q are points
/// of the face of h.
double angle_from(const Surface& surface, HalfedgeId h, const SurfacePoint& p,
                  const SurfacePoint& q) {
  const FaceId f = surface.face(h);
  const auto from = coordinates_in(surface, p, f).barycentric;
  const auto to = coordinates_in(surface, q, f).barycentric;
  std::size_t k = 0;  // the corner at the tail of h
  for (HalfedgeId side = surface.halfedge(f); side != h; side = surface.next(side)) ++k;
  const double along = to[(k + 1) % 3] - from[(k + 1) % 3];
  const double across = to[(k + 2) % 3] - from[(k + 2) % 3];
  const PlanePoint top = apex(length_of(surface, h), length_of(surface, surface.prev(h)),
                              length_of(surface, surface.next(h)));
  return std::atan2(across * top.y, along * length_of(surface, h) + across * top.x);
}

Direction direction_at(const Surface& surface, VertexId v, const SurfacePoint& p,
                       const SurfacePoint& q, FaceId f) {
  Direction direction{0, 0, surface.on_boundary(v)};
  const HalfedgeId first = surface.halfedge(v);
  HalfedgeId h = first;
  do {
    if (surface.face(h) == f) direction.angle = direction.cone + angle_from(surface, h, p, q);
    direction.cone += corner_angle(surface, h);
    h = surface.turn_ccw(h);
  } while (h != first && surface.has_face(h));
  return direction;
}

Direction direction_at(const Surface& surface, EdgeId e, const SurfacePoint& p,
                       const SurfacePoint& q, FaceId f) {
  const HalfedgeId h = halfedge_of(e);
  const bool left = surface.has_face(h) && surface.face(h) == f;
  const double angle = left ? angle_from(surface, h, p, q) : angle_from(surface, twin(h), p, q);
  const bool open = surface.on_boundary(e);
  return {left || open ? angle : angle + kPi, 2 * kPi, open};
}

/// The direction from p to q, both in face f.
Direction direction_to(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q,
                       FaceId f) {
  if (const auto* v = std::get_if<AtVertex>(&p.where())) {
    return direction_at(surface, v->vertex, p, q, f);
  }
  if (const auto* e = std::get_if<OnEdge>(&p.where())) {
    return direction_at(surface, e->edge, p, q, f);
  }
  const double angle = angle_from(surface, surface.halfedge(f), p, q);
  return {angle < 0 ? angle + 2 * kPi : angle, 2 * kPi, false};
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

double segment_length(const Surface& surface, const SurfaceCurve& curve, std::size_t i, FaceId f) {
  const std::size_t j = (i + 1) % curve.points.size();
  return distance_in_face(surface, coordinates_in(surface, curve.points[i], f),
                          coordinates_in(surface, curve.points[j], f));
}

struct Turn {
  double angle = 0;        ///< turning_angle()
  double toward_left = 0;  ///< signed_turning()
};

/// `face_before` and `face_after` are the faces of the two segments.
Turn turn_at(const Surface& surface, const SurfacePoint& before, FaceId face_before,
             const SurfacePoint& at, FaceId face_after, const SurfacePoint& after) {
  const Direction in = direction_to(surface, at, before, face_before);
  const Direction out = direction_to(surface, at, after, face_after);
  const double swept = in.angle - out.angle;  // counterclockwise from `out` to `in`
  if (in.open) {
    const double turn = kPi - std::abs(swept);
    return {std::clamp(turn, 0.0, kPi), swept > 0 ? turn : -turn};
  }
  const double left = swept < 0 ? swept + in.cone : swept;
  return {std::clamp(kPi - std::min(left, in.cone - left), 0.0, kPi), in.cone / 2 - left};
}

Turn turn_at(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
             const SurfacePoint& after) {
  return turn_at(surface, before, shared_face(surface, at, before), at,
                 shared_face(surface, at, after), after);
}

/// Measures the curve and lists its turns.
CurveMeasures measure(const Surface& surface, const SurfaceCurve& curve, CurveTurns& turns) {
  CurveMeasures measures;
  const std::size_t n = curve.points.size();
  std::vector<FaceId> faces;
  std::vector<double> at{0};  // of the points, along the curve
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    faces.push_back(face_of(surface, curve, i));
    at.push_back(at.back() + segment_length(surface, curve, i, faces.back()));
  }
  measures.length = at.back();
  turns.length = at.back();
  turns.closed = curve.closed;
  if (n < 2) return measures;
  for (std::size_t i = curve.closed ? 0 : 1; i < (curve.closed ? n : n - 1); ++i) {
    const std::size_t last = (i + n - 1) % n;
    const Turn turn = turn_at(surface, curve.points[last], faces[last], curve.points[i], faces[i],
                              curve.points[(i + 1) % n]);
    measures.total_curvature += turn.angle;
    measures.signed_curvature += turn.toward_left;
    turns.at.push_back(at[i]);
    turns.angle.push_back(turn.toward_left);
    if (turn.angle > measures.max_curvature) {
      measures.max_curvature = turn.angle;
      measures.max_at = i;
    }
  }
  return measures;
}

}  // namespace

double turning_angle(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                     const SurfacePoint& after) {
  return turn_at(surface, before, at, after).angle;
}

double signed_turning(const Surface& surface, const SurfacePoint& before, const SurfacePoint& at,
                      const SurfacePoint& after) {
  return turn_at(surface, before, at, after).toward_left;
}

double curve_length(const Surface& surface, const SurfaceCurve& curve) {
  double length = 0;
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    length += segment_length(surface, curve, i, face_of(surface, curve, i));
  }
  return length;
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

}  // namespace talweg

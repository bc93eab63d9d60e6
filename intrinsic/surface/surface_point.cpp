#include "talweg/intrinsic/surface/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_point(const std::string& message) {
  throw Error(ErrorCode::kBadCurve, message);
}

void check_exists(std::size_t index, std::size_t count, const char* kind) {
  if (index >= count) {
    bad_point("There is no " + std::string(kind) + " " + std::to_string(index) + " (the mesh has " +
              std::to_string(count) + ").");
  }
}

std::array<HalfedgeId, 3> sides(const Surface& surface, FaceId f) {
  const HalfedgeId h = surface.halfedge(f);
  return {h, surface.next(h), surface.prev(h)};
}

/// The point on side k of a face at fraction t from corner k.
SurfacePoint on_side(const Surface& surface, FaceId face, std::size_t k, double t) {
  const HalfedgeId h = sides(surface, face)[k];
  const EdgeId e = edge_of(h);
  return SurfacePoint::on_edge(surface, e, h == halfedge_of(e) ? t : 1 - t);
}

template <typename Visit>
void for_faces_at(const Surface& surface, const SurfacePoint& point, const Visit& visit) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    const HalfedgeId first = surface.halfedge(v->vertex);
    if (!first.valid()) return;
    HalfedgeId h = first;
    do {
      visit(surface.face(h));
      h = surface.turn_ccw(h);
    } while (h != first && surface.has_face(h));
  } else if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    for (const HalfedgeId h : {halfedge_of(e->edge), twin(halfedge_of(e->edge))}) {
      if (surface.has_face(h)) visit(surface.face(h));
    }
  } else {
    visit(std::get<InFace>(point.where()).face);
  }
}

bool contains(const Surface& surface, FaceId face, const SurfacePoint& point) {
  const auto any_side = [&](const auto& is_it) {
    const auto all = sides(surface, face);
    return is_it(all[0]) || is_it(all[1]) || is_it(all[2]);
  };
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return any_side([&](HalfedgeId h) { return surface.tail(h) == v->vertex; });
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return any_side([&](HalfedgeId h) { return edge_of(h) == e->edge; });
  }
  return std::get<InFace>(point.where()).face == face;
}

/// The face of smallest id that contains these two different corners.
FaceId face_of_both(const Surface& surface, VertexId v, VertexId w) {
  FaceId best;
  const HalfedgeId first = surface.halfedge(v);
  if (!first.valid()) return best;
  HalfedgeId h = first;
  do {
    const HalfedgeId next = surface.next(h), prev = surface.next(next);
    const FaceId f = surface.face(h);
    const bool both = surface.tail(next) == w || surface.tail(prev) == w;
    if (both && (!best.valid() || f < best)) best = f;
    h = twin(prev);
  } while (h != first && surface.has_face(h));
  return best;
}

}  // namespace

SurfacePoint SurfacePoint::at_vertex(const Surface& surface, VertexId vertex) {
  check_exists(vertex.index(), surface.vertex_count(), "vertex");
  return SurfacePoint(AtVertex{vertex});
}

SurfacePoint SurfacePoint::on_edge(const Surface& surface, EdgeId edge, double t) {
  check_exists(edge.index(), surface.edge_count(), "edge");
  if (!(t > 0 && t < 1)) bad_point("An edge point needs 0 < t < 1, not " + std::to_string(t) + ".");
  return SurfacePoint(OnEdge{edge, t});
}

SurfacePoint SurfacePoint::in_face(const Surface& surface, FaceId face,
                                   const std::array<double, 3>& barycentric) {
  check_exists(face.index(), surface.face_count(), "face");
  const double sum = barycentric[0] + barycentric[1] + barycentric[2];
  const bool positive =
      std::all_of(barycentric.begin(), barycentric.end(), [](double b) { return b > 0 && b < 1; });
  if (!positive || !(std::abs(sum - 1) <= 1e-6)) {
    bad_point("A point inside face " + std::to_string(face.index()) +
              " needs three barycentrics > 0 that sum to 1.");
  }
  return SurfacePoint(InFace{face, barycentric});
}

SurfacePoint SurfacePoint::from_barycentric(const Surface& surface, FaceId face,
                                            const std::array<double, 3>& barycentric,
                                            double tolerance) {
  check_exists(face.index(), surface.face_count(), "face");
  const std::array<double, 3>& b = barycentric;
  const bool finite = std::isfinite(b[0]) && std::isfinite(b[1]) && std::isfinite(b[2]);
  if (!finite || std::abs(b[0] + b[1] + b[2] - 1) > 1e-6 ||
      std::min({b[0], b[1], b[2]}) < -tolerance) {
    bad_point("The barycentrics of a point in face " + std::to_string(face.index()) +
              " are not in [0, 1] with sum 1.");
  }
  std::array<bool, 3> zero{};
  for (std::size_t k = 0; k < 3; ++k) zero[k] = b[k] <= tolerance;
  const auto zeros = std::count(zero.begin(), zero.end(), true);
  if (zeros == 2) {
    const auto k =
        static_cast<std::size_t>(std::find(zero.begin(), zero.end(), false) - zero.begin());
    return at_vertex(surface, surface.corners(face)[k]);
  }
  if (zeros == 1) {
    const auto k =
        static_cast<std::size_t>(std::find(zero.begin(), zero.end(), true) - zero.begin());
    const double from = b[(k + 1) % 3];
    const double to = b[(k + 2) % 3];
    const double t = to / (from + to);
    // A coordinate above the tolerance can still vanish by rounding against the other.
    if (!(t > 0)) return at_vertex(surface, surface.corners(face)[(k + 1) % 3]);
    if (!(t < 1)) return at_vertex(surface, surface.corners(face)[(k + 2) % 3]);
    return on_side(surface, face, (k + 1) % 3, t);
  }
  if (const auto whole = std::find_if(b.begin(), b.end(), [](double x) { return x >= 1; });
      whole != b.end()) {
    return at_vertex(surface, surface.corners(face)[static_cast<std::size_t>(whole - b.begin())]);
  }
  return in_face(surface, face, b);
}

SurfaceElement element_of(const SurfacePoint& point) {
  using Kind = SurfaceElement::Kind;
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return {Kind::kVertex, v->vertex.index()};
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return {Kind::kEdge, e->edge.index()};
  return {Kind::kFace, std::get<InFace>(point.where()).face.index()};
}

std::vector<FaceId> faces_at(const Surface& surface, const SurfacePoint& point) {
  std::vector<FaceId> faces;
  for_faces_at(surface, point, [&](FaceId f) { faces.push_back(f); });
  return faces;
}

FaceCoordinates coordinates_in(const Surface& surface, const SurfacePoint& point, FaceId face) {
  FaceCoordinates result{face, {0, 0, 0}};
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    const auto corners = surface.corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] != v->vertex) continue;
      result.barycentric[k] = 1;
      return result;
    }
  } else if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    const auto side = sides(surface, face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (edge_of(side[k]) != e->edge) continue;
      const bool along = side[k] == halfedge_of(e->edge);
      result.barycentric[k] = along ? 1 - e->t : e->t;
      result.barycentric[(k + 1) % 3] = along ? e->t : 1 - e->t;
      return result;
    }
  } else if (const auto& inside = std::get<InFace>(point.where()); inside.face == face) {
    result.barycentric = inside.barycentric;
    return result;
  }
  bad_point("Face " + std::to_string(face.index()) + " does not contain the point.");
}

FaceId common_face(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q) {
  const auto *v = std::get_if<AtVertex>(&p.where()), *w = std::get_if<AtVertex>(&q.where());
  if (v != nullptr && w != nullptr && v->vertex != w->vertex) {
    return face_of_both(surface, v->vertex, w->vertex);
  }
  // A vertex has many faces around it, the other points have at most two.
  const SurfacePoint &many = p.is_vertex() ? p : q, &few = p.is_vertex() ? q : p;
  FaceId best;
  for_faces_at(surface, few, [&](FaceId f) {
    if ((!best.valid() || f < best) && contains(surface, f, many)) best = f;
  });
  return best;
}

FaceId any_face(const Surface& surface, const SurfacePoint& point) {
  FaceId best;
  for_faces_at(surface, point, [&](FaceId f) {
    if (!best.valid() || f < best) best = f;
  });
  return best;
}

double distance_in_face(const Surface& surface, const FaceCoordinates& p,
                        const FaceCoordinates& q) {
  std::array<double, 3> d{};
  for (std::size_t k = 0; k < 3; ++k) d[k] = p.barycentric[k] - q.barycentric[k];
  double squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = surface.length(edge_of(sides(surface, p.face)[k]));
    squared -= side * side * d[k] * d[(k + 1) % 3];
  }
  return std::sqrt(std::max(squared, 0.0));
}

}  // namespace talweg

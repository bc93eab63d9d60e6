#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "talweg/intrinsic/exact_distance/polyline_sources.hpp"

namespace talweg {
namespace {

using Nearest = PolylineDistance::Nearest;

// Edges of ordinary faces have 3 to 20 windows, edges of needles hundreds. A window takes 64 bytes
// and about a microsecond.
constexpr std::size_t kWindows = 100'000, kWindowsOfPoint = 32, kWindowsOfEdge = 32,
                      kMostWindows = 8'000'000;

}  // namespace

PolylineDistance::PolylineDistance(const Surface& surface)
    : surface_(&surface),
      front_(surface),
      components_(surface),
      faces_(surface),
      edge_path_distances_(surface) {}

void PolylineDistance::forget(double step, const WindowFront::Room& room) {
  front_.reset(step, room);
  components_.clear();
  faces_.clear();
  edge_path_distances_.clear();
}

void PolylineDistance::set_with_few_windows(std::span<const SurfaceCurve> curves) {
  std::size_t points = 0;
  for (const SurfaceCurve& curve : curves) points += curve.points.size();
  set(curves, {kWindows + kWindowsOfPoint * points, kWindowsOfEdge, kMostWindows});
}

void PolylineDistance::set(std::span<const SurfaceCurve> curves, const WindowFront::Room& room) {
  PolylinePieces pieces = pieces_of(*surface_, curves);
  forget(step_width(*surface_, pieces), room);
  pieces_ = std::move(pieces);
  try {
    send_pieces(*surface_, pieces_, front_);
  } catch (...) {
    forget(1, {});
    pieces_ = {};
    throw;
  }
}

Nearest PolylineDistance::finish(Nearest nearest) const {
  if (std::isinf(nearest.distance)) return Nearest::none();
  nearest.arc_length = std::clamp(nearest.arc_length, 0.0, pieces_.lengths[nearest.curve]);
  return nearest;
}

/// Whether a distance known at the vertex `beside`, or in an element next to it, is final, or the
/// front never reaches this vertex.
bool PolylineDistance::is_final_at(VertexId beside, double distance) {
  return front_.is_final(distance) || components_.keep_out(front_, beside);
}

Nearest PolylineDistance::at_vertex(VertexId v) {
  const Nearest& known = front_.vertices()[v];
  while (!is_final_at(v, known.distance)) front_.march();
  return finish(known);
}

Nearest PolylineDistance::at_vertex_bounded(VertexId v, double exact) {
  const Nearest& known = front_.vertices()[v];
  while (!is_final_at(v, std::min(known.distance, exact))) front_.march();
  if (known.distance <= exact || components_.keep_out(front_, v)) return finish(known);
  return finish(edge_path_distances_.shortest(v, exact, front_.vertices(), front_.work()));
}

Nearest PolylineDistance::on_edge(EdgeId edge, double t) {
  const VertexId tail = surface_->tail(halfedge_of(edge));
  const double x = t * surface_->length(edge);
  for (;;) {
    const Nearest known = front_.on_edge(edge, x);
    if (is_final_at(tail, known.distance)) return finish(known);
    front_.march();
  }
}

Nearest PolylineDistance::at(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return at_vertex(v->vertex);
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return on_edge(e->edge, e->t);
  const auto& inside = std::get<InFace>(point.where());
  FacePaths::Hit hit;
  final_paths(inside.face, inside.barycentric, hit);
  return finish(hit.nearest);
}

PolylineDistance::FaceValue PolylineDistance::at_face(FaceId face, const Barycentric& b,
                                                      PlanePoint direction) {
  FacePaths::Hit hit;
  const FacePaths& paths = final_paths(face, b, hit);
  const Nearest nearest = finish(hit.nearest);
  FaceValue result{nearest.distance, 0, nearest.curve, nearest.arc_length, 0};
  if (std::isinf(nearest.distance)) return result;
  const FacePaths::Slopes slopes = paths.slopes(hit, b, direction);
  result.slope = slopes.distance;
  result.arc_slope = slopes.arc_length;
  return result;
}

double PolylineDistance::below(double limit, const SurfacePoint& point) {
  const VertexId beside = vertex_beside(point);
  double known = known_at(point);
  while (!is_final_at(beside, std::min(known, limit))) {
    front_.march();
    known = known_at(point);
  }
  return known < limit ? known : std::numeric_limits<double>::infinity();
}

std::vector<Stretch> PolylineDistance::within(EdgeId edge, double limit) {
  constexpr double kGap = 1e-11;  // relative to the edge: the largest gap of adjacent windows
  reach(limit);
  const double length = surface_->length(edge);
  const HalfedgeId h = halfedge_of(edge);
  const double tail = front_.vertices()[surface_->tail(h)].distance;
  const double head = front_.vertices()[surface_->head(h)].distance;
  std::vector<Stretch> parts;
  if (tail <= limit) parts.push_back({0, std::min(length, limit - tail)});
  if (head <= limit) parts.push_back({std::max(0.0, length - (limit - head)), length});
  front_.windows().each(edge, [&](const EdgeWindow& window) {
    const auto way = [&](double x) {
      const double bend = std::clamp(x, window.begin, window.end);
      return window.value(bend) + std::abs(x - bend);
    };
    if (const auto part = stretch_below(way, length, limit)) parts.push_back(*part);
  });
  return joined_stretches(std::move(parts), kGap * length);
}

const FacePaths& PolylineDistance::paths_into(FaceId face, double limit) {
  reach(limit);
  if (!faces_.contain(face) || !front_.is_behind(limit, faces_.at(face).front)) {
    faces_.copy(face, front_, pieces_);
  }
  return faces_.at(face).paths;
}

/// The ways into a face, final as far as the answer at b needs them; sets `hit` to this answer.
const FacePaths& PolylineDistance::final_paths(FaceId face, const Barycentric& b,
                                               FacePaths::Hit& hit) {
  if (!faces_.contain(face)) faces_.copy(face, front_, pieces_);
  for (;;) {
    const KnownFaces::Known& known = faces_.at(face);
    hit = known.paths.hit(b);
    if (front_.is_behind(hit.nearest.distance, known.front)) return known.paths;
    if (known.front == front_.distance()) {
      const VertexId corner = surface_->tail(surface_->halfedge(face));
      if (front_.is_done() || components_.keep_out(front_, corner)) return known.paths;
      front_.march();
    }
    faces_.copy(face, front_, pieces_);
  }
}

/// A vertex of the element that contains a point.
VertexId PolylineDistance::vertex_beside(const SurfacePoint& point) const {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex;
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return surface_->tail(halfedge_of(e->edge));
  }
  return surface_->tail(surface_->halfedge(std::get<InFace>(point.where()).face));
}

/// The currently known distance, without marching.
double PolylineDistance::known_at(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return front_.vertices()[v->vertex].distance;
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return front_.on_edge(e->edge, e->t * surface_->length(e->edge)).distance;
  }
  const auto& [face, b] = std::get<InFace>(point.where());
  if (!faces_.contain(face) || faces_.at(face).front != front_.distance()) {
    faces_.copy(face, front_, pieces_);
  }
  return faces_.at(face).paths.hit(b).nearest.distance;
}

}  // namespace talweg

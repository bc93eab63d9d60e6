// PolylineDistance: queries.
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talweg {
namespace {

using Nearest = PolylineDistance::Nearest;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
}  // namespace

/// The nearer of the ways along the edge from its ends.
Nearest PolylineDistance::along_edge(const Nearest& tail, const Nearest& head, double length,
                                     double x) {
  const Nearest from_tail = farther(tail, x), from_head = farther(head, length - x);
  return is_nearer(from_head, from_tail) ? from_head : from_tail;
}

Nearest PolylineDistance::known_on_edge(EdgeId edge, double x) const {
  const double length = surface_->length(edge);
  Nearest best = along_edge(vertex_[surface_->tail(halfedge_of(edge)).index()],
                            vertex_[surface_->head(halfedge_of(edge)).index()], length, x);
  windows_.each(edge, [&](const EdgeWindow& window) {
    const double bend = std::clamp(x, window.begin, window.end);
    const Nearest other{window.value(bend) + std::abs(x - bend), window.curve, window.arc_at(bend)};
    if (is_nearer(other, best)) best = other;
  });
  if (best.distance <= kRounding * length) best.distance = 0;
  return best;
}

Nearest PolylineDistance::finish(Nearest nearest) const {
  if (std::isinf(nearest.distance)) return {kInfinity, 0, 0};
  nearest.arc_length = std::clamp(nearest.arc_length, 0.0, pieces_.lengths[nearest.curve]);
  return nearest;
}

/// Whether a vertex that has not been reached will never be reached. Components are computed only
/// after so many windows that this costs little in comparison.
bool PolylineDistance::marches_in_vain(VertexId v) {
  if (std::isfinite(vertex_[v.index()].distance)) return false;
  if (with_curve_.empty()) {
    if (windows_.size() < surface_->vertex_count() / 8) return false;
    if (component_.empty()) component_ = components_of(*surface_).of_vertex;
    // Everything touched so far is connected to a curve.
    for (const VertexId touched : touched_vertices_) {
      with_curve_.push_back(component_[touched.index()]);
    }
    std::sort(with_curve_.begin(), with_curve_.end());
    with_curve_.erase(std::unique(with_curve_.begin(), with_curve_.end()), with_curve_.end());
  }
  return !std::binary_search(with_curve_.begin(), with_curve_.end(), component_[v.index()]);
}

Nearest PolylineDistance::at_vertex(VertexId v) {
  const Nearest& known = vertex_[v.index()];
  while (!is_final(known.distance) && !marches_in_vain(v)) march();
  return finish(known);
}

Nearest PolylineDistance::on_edge(EdgeId edge, double t) {
  const VertexId tail = surface_->tail(halfedge_of(edge));
  for (;;) {
    const Nearest known = known_on_edge(edge, t * surface_->length(edge));
    if (is_final(known.distance) || marches_in_vain(tail)) return finish(known);
    march();
  }
}

Nearest PolylineDistance::at(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return at_vertex(v->vertex);
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return on_edge(e->edge, e->t);
  const auto& inside = std::get<InFace>(point.where());
  return in_face(inside.face, inside.barycentric);
}

/// A vertex of the face, edge or vertex where a point lies.
VertexId PolylineDistance::vertex_beside(const SurfacePoint& point) const {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex;
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return surface_->tail(halfedge_of(e->edge));
  }
  return surface_->tail(surface_->halfedge(std::get<InFace>(point.where()).face));
}

double PolylineDistance::known_at(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return vertex_[v->vertex.index()].distance;
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return known_on_edge(e->edge, e->t * surface_->length(e->edge)).distance;
  }
  const auto& inside = std::get<InFace>(point.where());
  return hit_in(fresh_copy(inside.face), inside.barycentric).nearest.distance;
}

double PolylineDistance::below(double limit, const SurfacePoint& point) {
  const VertexId beside = vertex_beside(point);
  double known = known_at(point);
  while (!is_final(std::min(known, limit)) && !marches_in_vain(beside)) {
    march();
    known = known_at(point);
  }
  return known < limit ? known : kInfinity;
}

}  // namespace talweg

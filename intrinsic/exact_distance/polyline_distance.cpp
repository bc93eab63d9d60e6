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

/// The way along the edge from one of its ends.
PolylineDistance::EdgeHit PolylineDistance::hit_along(const Nearest& tail, const Nearest& head,
                                                      double length, double x) {
  EdgeHit hit{farther(tail, x), nullptr, 0};
  if (const Nearest other = farther(head, length - x); is_nearer(other, hit.nearest)) {
    hit = {other, nullptr, length};
  }
  return hit;
}

void PolylineDistance::offer(EdgeHit& hit, const EdgeWindow& window, double x) {
  const double bend = std::clamp(x, window.begin, window.end);
  const double distance = window.value(bend) + std::abs(x - bend);
  if (distance > hit.nearest.distance) return;
  const Nearest nearest{distance, window.curve, window.arc_at(bend)};
  // A window's derivatives are preferred to those along the edge.
  if (is_nearer(nearest, hit.nearest) ||
      (hit.window == nullptr && nearest.distance == hit.nearest.distance)) {
    hit = {nearest, &window, bend};
  }
}

PolylineDistance::EdgeHit PolylineDistance::hit_on_edge(EdgeId edge, double x) const {
  const double length = surface_->length(edge);
  EdgeHit hit = hit_along(vertex_[surface_->tail(halfedge_of(edge)).index()],
                          vertex_[surface_->head(halfedge_of(edge)).index()], length, x);
  windows_.each(edge, [&](const EdgeWindow& window) { offer(hit, window, x); });
  if (hit.nearest.distance <= kRounding * length) hit.nearest.distance = 0;
  return hit;
}

PolylineDistance::EdgeHit PolylineDistance::hit_in(const EdgeCopy& copy, double x) const {
  EdgeHit hit = hit_along(copy.tail, copy.head, copy.length, x);
  const EdgeWindow* const first = copied_.data() + copy.first;
  for (std::uint32_t i = 0; i < copy.count; ++i) offer(hit, first[i], x);
  if (hit.nearest.distance <= kRounding * copy.length) hit.nearest.distance = 0;
  return hit;
}

void PolylineDistance::copy_edge(EdgeId edge) {
  std::uint32_t& id = copy_of_[edge.index()];
  if (id == kNone) {
    id = static_cast<std::uint32_t>(copies_.size());
    copies_.emplace_back();
  }
  EdgeCopy& copy = copies_[id];
  copy.edge = edge;
  copy.length = surface_->length(edge);
  copy.front = queue_.front();
  copy.tail = vertex_[surface_->tail(halfedge_of(edge)).index()];
  copy.head = vertex_[surface_->head(halfedge_of(edge)).index()];
  of_one_edge_.clear();
  windows_.each(edge, [&](const EdgeWindow& window) { of_one_edge_.push_back(window); });
  store(copy, copied_, of_one_edge_);
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

PolylineDistance::EdgeHit PolylineDistance::final_hit(EdgeId edge, double x) {
  const VertexId tail = surface_->tail(halfedge_of(edge));
  for (;;) {
    const EdgeHit hit = hit_on_edge(edge, x);
    if (is_final(hit.nearest.distance) || marches_in_vain(tail)) return hit;
    march();
  }
}

/// A copy of the edge that is final for the answer at t; renewed only if the front has advanced
/// since.
const PolylineDistance::EdgeCopy& PolylineDistance::final_copy(EdgeId edge, double t,
                                                               EdgeHit& hit) {
  if (copy_of_[edge.index()] == kNone) copy_edge(edge);
  for (;;) {
    const EdgeCopy& copy = copies_[copy_of_[edge.index()]];
    hit = hit_in(copy, t * copy.length);
    if (hit.nearest.distance + queue_.step() / 64 < copy.front) return copy;
    if (copy.front == queue_.front()) {
      if (queue_.empty() || marches_in_vain(surface_->tail(halfedge_of(edge)))) return copy;
      march();
    }
    copy_edge(edge);
  }
}

Nearest PolylineDistance::on_edge(EdgeId edge, double t) {
  return finish(final_hit(edge, t * surface_->length(edge)).nearest);
}

PolylineDistance::EdgeValue PolylineDistance::at_edge(EdgeId edge, double t) {
  EdgeHit hit;
  const double length = final_copy(edge, t, hit).length;
  const Nearest nearest = finish(hit.nearest);
  EdgeValue result{nearest.distance, 0, 0, nearest.curve, nearest.arc_length, 0};
  if (std::isinf(nearest.distance)) return result;
  // Narrow gaps between windows come from rounding.
  if (hit.window != nullptr && std::abs(t * length - hit.bend) <= 1e-9 * length) {
    const EdgeWindow::Derivatives d = hit.window->derivatives(hit.bend);
    result.first = d.slope * length;
    result.second = d.curvature * length * length;
    result.arc_first = hit.window->arc_slope() * length;
  } else {
    result.first = t * length < hit.bend ? -length : length;
  }
  return result;
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
    return hit_on_edge(e->edge, e->t * surface_->length(e->edge)).nearest.distance;
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

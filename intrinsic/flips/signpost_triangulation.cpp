#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

namespace {

/// Reserves room for the points that a drawing inserts, so that arrays of the mesh's size need not
/// be moved. Memory that is not written costs nothing.
constexpr std::size_t with_room(std::size_t count) { return count + count / 4 + 1024; }

template <class T>
std::vector<T> copied(std::span<const T> values) {
  std::vector<T> copy;
  copy.reserve(with_room(values.size()));
  copy.assign(values.begin(), values.end());
  return copy;
}

template <class T>
ZeroedVector<T> zeros(std::size_t count) {
  ZeroedVector<T> values;
  values.reserve(with_room(count));
  values.resize(count);
  return values;
}

}  // namespace

SignpostTriangulation::SignpostTriangulation(const Surface& surface)
    : surface_(&surface),
      halfedges_(copied(surface.halfedges())),
      vertex_halfedge_(copied(surface.vertex_halfedges())),
      surface_length_(copied(surface.lengths())),
      edge_epoch_(zeros<std::uint32_t>(surface.edge_count())),
      vertex_epoch_(zeros<std::uint32_t>(surface.vertex_count())),
      length_(zeros<double>(surface.edge_count())),
      direction_(zeros<double>(surface.halfedge_count())),
      cone_(zeros<double>(surface.vertex_count())) {}

void SignpostTriangulation::set_metric(Metric metric) {
  assert(log_.empty());
  metric_ = std::move(metric);
  forget();
}

void SignpostTriangulation::forget() {
  touched_.clear();
  if (++epoch_ == 0) {
    std::fill(edge_epoch_.begin(), edge_epoch_.end(), 0U);
    std::fill(vertex_epoch_.begin(), vertex_epoch_.end(), 0U);
    epoch_ = 1;
  }
}

void SignpostTriangulation::prepare_all() {
  for (std::size_t e = 0; e < edge_count(); ++e) length(EdgeId{e});
  for (std::size_t v = 0; v < vertex_count(); ++v) touch(VertexId{v});
}

HalfedgeId SignpostTriangulation::find_halfedge(VertexId a, VertexId b) const {
  const HalfedgeId first = halfedge(a);
  if (!first.valid()) return {};
  HalfedgeId h = first;
  do {
    if (head(h) == b) return h;
    if (!has_face(h)) break;
    h = turn_ccw(h);
  } while (h != first);
  return {};
}

double SignpostTriangulation::length(EdgeId e) {
  const std::size_t i = e.index();
  if (edge_epoch_[i] != epoch_) {
    edge_epoch_[i] = epoch_;
    const HalfedgeId h = halfedge_of(e);
    length_[i] = metric_ ? metric_(tail(h), head(h), surface_length_[i]) : surface_length_[i];
  }
  return length_[i];
}

double SignpostTriangulation::corner_angle(HalfedgeId h) {
  return angle_between(length(h), length(prev(h)), length(next(h)));
}

void SignpostTriangulation::touch(VertexId v) {
  if (vertex_epoch_[v.index()] == epoch_) return;
  vertex_epoch_[v.index()] = epoch_;
  touched_.push_back(v);
  double angle = 0;
  const HalfedgeId first = halfedge(v);
  HalfedgeId h = first;
  if (h.valid()) {
    do {
      direction_[h.index()] = angle;
      if (!has_face(h)) break;
      angle += corner_angle(h);
      h = turn_ccw(h);
    } while (h != first);
  }
  cone_[v.index()] = angle;
}

double SignpostTriangulation::cone_angle(VertexId v) {
  touch(v);
  return cone_[v.index()];
}

double SignpostTriangulation::swept(HalfedgeId from, HalfedgeId to) {
  double angle = 0;
  while (from != to) {
    if (!has_face(from)) return std::numeric_limits<double>::infinity();
    angle += corner_angle(from);
    from = turn_ccw(from);
  }
  return angle;
}

double SignpostTriangulation::angle_ccw(HalfedgeId from, HalfedgeId to) {
  if (from == to) return 0;
  const VertexId v = tail(from);
  touch(v);
  const double cone = cone_[v.index()];
  const double difference = direction_[to.index()] - direction_[from.index()];
  // Close to 0 or to the full cone the sign depends on rounding, so the corners are summed up.
  const double unsure = 1e-6;
  if (std::abs(difference) < unsure || std::abs(difference) > cone - unsure) return swept(from, to);
  if (difference > 0) return difference;
  return on_boundary(v) ? std::numeric_limits<double>::infinity() : difference + cone;
}

double SignpostTriangulation::wrapped(double angle, VertexId v) const {
  const double cone = cone_[v.index()];
  return angle >= cone && !on_boundary(v) ? angle - cone : angle;
}

// Faces (h, h1, h2) and (t, t1, t2) with h: c → d become (h, h2, t1) and (t, t2, h1) with h: b → a.
void SignpostTriangulation::rotate_ccw(HalfedgeId h) {
  const HalfedgeId t = twin(h);
  const HalfedgeId h1 = next(h), h2 = next(h1), t1 = next(t), t2 = next(t1);
  halfedges_[h.index()] = {h2, tail(t2), surface_face(h)};
  halfedges_[t.index()] = {t2, tail(h2), surface_face(t)};
  halfedges_[h2.index()].next = t1;
  halfedges_[t1.index()].next = h;
  halfedges_[t2.index()].next = h1;
  halfedges_[h1.index()].next = t;
}

void SignpostTriangulation::rotate_cw(HalfedgeId h) {
  const HalfedgeId t = twin(h);
  const HalfedgeId h2 = next(h), t1 = next(h2), t2 = next(t), h1 = next(t2);
  halfedges_[h.index()] = {h1, tail(t1), surface_face(h)};
  halfedges_[t.index()] = {t1, tail(h1), surface_face(t)};
  halfedges_[h1.index()].next = h2;
  halfedges_[h2.index()].next = h;
  halfedges_[t1.index()].next = t2;
  halfedges_[t2.index()].next = t;
}

bool SignpostTriangulation::flip(EdgeId e) {
  if (on_boundary(e)) return false;
  const HalfedgeId h = halfedge_of(e), t = twin(h);
  const HalfedgeId h1 = next(h), h2 = next(h1), t1 = next(t), t2 = next(t1);
  if (h1 == t || h2 == t) return false;  // one face on both sides

  // Lays the diamond out in the plane: h from (0, 0) to (base, 0), one face above, the other below.
  const double base = length(e);
  const PlanePoint above = apex(base, length(h2), length(h1));
  const PlanePoint below = apex(base, length(t1), length(t2));
  const double left = above.x * below.y + below.x * above.y;
  const double right = (base - above.x) * below.y + (base - below.x) * above.y;
  const double diagonal = std::hypot(above.x - below.x, above.y + below.y);
  if (!(left > 0 && right > 0 && diagonal > 0 && std::isfinite(diagonal))) return false;

  if (keep_trace_) {
    for (const HalfedgeId corner : {h, h1, h2, t2}) touch(tail(corner));
    const VertexId c = tail(h), d = tail(t);
    Flip flip{e, base, {direction_[h.index()], direction_[t.index()]}, {false, false}};
    // A boundary vertex's own halfedge has no face on its other side, so it is never flipped away.
    if (vertex_halfedge_[c.index()] == h) {
      flip.represented[0] = true;
      vertex_halfedge_[c.index()] = t1;
    }
    if (vertex_halfedge_[d.index()] == t) {
      flip.represented[1] = true;
      vertex_halfedge_[d.index()] = h1;
    }
    log_.push_back(flip);
  }
  rotate_ccw(h);
  length_[e.index()] = diagonal;
  if (keep_trace_) {
    direction_[h.index()] = wrapped(direction_[t2.index()] + corner_angle(t2), tail(h));
    direction_[t.index()] = wrapped(direction_[h2.index()] + corner_angle(h2), tail(t));
  }
  return true;
}

void SignpostTriangulation::undo_flip() {
  const Flip flip = log_.back();
  log_.pop_back();
  const HalfedgeId h = halfedge_of(flip.edge), t = twin(h);
  rotate_cw(h);
  length_[flip.edge.index()] = flip.length;
  direction_[h.index()] = flip.direction[0];
  direction_[t.index()] = flip.direction[1];
  if (flip.represented[0]) vertex_halfedge_[tail(h).index()] = h;
  if (flip.represented[1]) vertex_halfedge_[tail(t).index()] = t;
}

HalfedgeId SignpostTriangulation::new_edge(VertexId tail, VertexId head, double length) {
  const HalfedgeId h{halfedges_.size()};
  halfedges_.push_back({{}, tail, {}});
  halfedges_.push_back({{}, head, {}});
  surface_length_.push_back(length);
  length_.push_back(0);
  edge_epoch_.push_back(0);
  direction_.resize(halfedges_.size(), 0);
  return h;
}

VertexId SignpostTriangulation::new_vertex(const SurfacePoint& location) {
  assert(log_.empty());
  forget();  // drops the directions around the new vertex
  vertex_halfedge_.emplace_back();
  vertex_epoch_.push_back(0);
  cone_.push_back(0);
  inserted_.push_back(location);
  return VertexId{vertex_count() - 1};
}

void SignpostTriangulation::make_face(HalfedgeId a, HalfedgeId b, HalfedgeId c, FaceId face) {
  const HalfedgeId side[3] = {a, b, c};
  for (std::size_t k = 0; k < 3; ++k) {
    halfedges_[side[k].index()].next = side[(k + 1) % 3];
    halfedges_[side[k].index()].face = face;
    note_change(side[k]);
  }
}

VertexId SignpostTriangulation::split_edge(HalfedgeId h, const EdgeSplit& lengths,
                                           const SurfacePoint& location) {
  assert(has_face(h));
  const HalfedgeId t = twin(h);
  const VertexId b = head(h);
  const VertexId m = new_vertex(location);
  const HalfedgeId h1 = next(h), h2 = prev(h);
  const HalfedgeId t1 = has_face(t) ? next(t) : HalfedgeId{};
  const HalfedgeId t2 = has_face(t) ? prev(t) : HalfedgeId{};

  const HalfedgeId n = new_edge(m, b, lengths.to_head);
  const HalfedgeId p = new_edge(m, tail(h2), lengths.to_left);
  surface_length_[edge_of(h).index()] = lengths.from_tail;
  halfedges_[t.index()].tail = m;
  note_change(t);
  if (vertex_halfedge_[b.index()] == t) vertex_halfedge_[b.index()] = twin(n);
  vertex_halfedge_[m.index()] = n;
  make_face(h, p, h2, surface_face(h));
  make_face(n, h1, twin(p), surface_face(h));
  if (t1.valid()) {
    const HalfedgeId q = new_edge(m, tail(t2), lengths.to_right);
    make_face(t, t1, twin(q), surface_face(t));
    make_face(twin(n), q, t2, surface_face(t));
  }
  return m;
}

VertexId SignpostTriangulation::split_face(HalfedgeId h, const std::array<double, 3>& lengths,
                                           const SurfacePoint& location) {
  const HalfedgeId h1 = next(h), h2 = prev(h);
  const FaceId face = surface_face(h);
  const VertexId m = new_vertex(location);
  const HalfedgeId x = new_edge(m, tail(h), lengths[0]);
  const HalfedgeId y = new_edge(m, tail(h1), lengths[1]);
  const HalfedgeId z = new_edge(m, tail(h2), lengths[2]);
  vertex_halfedge_[m.index()] = x;
  make_face(h, twin(y), x, face);
  make_face(h1, twin(z), y, face);
  make_face(h2, twin(x), z, face);
  return m;
}

void SignpostTriangulation::flip_unlogged(EdgeId e, double length) {
  assert(log_.empty() && e.index() >= surface_->edge_count());
  forget();
  const HalfedgeId h = halfedge_of(e), t = twin(h);
  const HalfedgeId h1 = next(h), h2 = next(h1), t1 = next(t), t2 = next(t1);
  if (halfedge(tail(h)) == h) vertex_halfedge_[tail(h).index()] = t1;
  if (halfedge(tail(t)) == t) vertex_halfedge_[tail(t).index()] = h1;
  rotate_ccw(h);
  surface_length_[e.index()] = length;
  for (const HalfedgeId side : {h1, h2, t1, t2}) {
    if (edge_of(side).index() < surface_->edge_count()) note_change(side);
  }
}

void SignpostTriangulation::remove_inserted() {
  assert(log_.empty());
  const std::size_t edges = surface_->edge_count();
  halfedges_.resize(2 * edges);
  direction_.resize(2 * edges);
  surface_length_.resize(edges);
  length_.resize(edges);
  edge_epoch_.resize(edges);
  vertex_halfedge_.resize(surface_->vertex_count());
  vertex_epoch_.resize(surface_->vertex_count());
  cone_.resize(surface_->vertex_count());
  inserted_.clear();
  for (const HalfedgeId h : changed_) {
    if (h.index() >= 2 * edges) continue;
    halfedges_[h.index()] = surface_->halfedges()[h.index()];
    const VertexId v = surface_->tail(h);
    vertex_halfedge_[v.index()] = surface_->halfedge(v);
    surface_length_[edge_of(h).index()] = surface_->length(edge_of(h));
  }
  changed_.clear();
  set_metric({});
}

SurfacePoint SignpostTriangulation::location(VertexId v) const {
  const std::size_t base = surface_->vertex_count();
  if (v.index() < base) return SurfacePoint::at_vertex(*surface_, v);
  return inserted_[v.index() - base];
}

}  // namespace talweg

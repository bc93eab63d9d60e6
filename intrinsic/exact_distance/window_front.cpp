#include "talweg/intrinsic/exact_distance/window_front.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/intrinsic/exact_distance/face_beyond.hpp"
#include "talweg/intrinsic/exact_distance/shorter_parts.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

WindowFront::WindowFront(const Surface& surface)
    : surface_(&surface),
      bending_(surface),
      vertices_(surface.vertex_count()),
      windows_(surface.edge_count()) {}

void WindowFront::reset(double step, const Room& room) {
  vertices_.clear();
  windows_.clear();
  queue_.reset(step);
  room_ = room;
  exact_within_ = HUGE_VAL;
}

void WindowFront::send(const EdgeWindow& window) {
  const HalfedgeId side = twin(window.into);
  const EdgeId edge = edge_of(side);
  const EdgeWindow turned = window.turned(surface_->length(edge));
  insert(side == halfedge_of(edge) ? window : turned);
  if (window.from_point()) pass_on(turned);
}

void WindowFront::start_at(VertexId v, const NearestOnCurve& from) {
  lower(v, from);
  queue_.push({from.distance, static_cast<std::uint32_t>(v.index()), kVertexItem});
}

NearestOnCurve WindowFront::on_edge(EdgeId edge, double x) const {
  const double length = surface_->length(edge);
  const HalfedgeId h = halfedge_of(edge);
  NearestOnCurve best =
      along_edge(vertices_[surface_->tail(h)], vertices_[surface_->head(h)], length, x);
  windows_.each(edge, [&](const EdgeWindow& window) {
    const double bend = std::clamp(x, window.begin, window.end);
    const NearestOnCurve other{window.value(bend) + std::abs(x - bend), window.curve,
                               window.arc_at(bend)};
    if (other.is_nearer_than(best)) best = other;
  });
  best.drop_rounding(length);
  return best;
}

/// Prefetches memory for the next items, whose windows and edges are scattered.
void WindowFront::fetch_ahead() const {
  if (const auto* item = queue_.ahead(5); item != nullptr && item->kind == kWindowItem) {
    windows_.fetch(item->id);
  }
  if (const auto* item = queue_.ahead(3); item != nullptr && item->kind == kWindowItem) {
    __builtin_prefetch(&surface_->halfedges()[windows_[item->id].into.index()]);
  }
  if (const auto* item = queue_.ahead(1); item != nullptr && item->kind == kWindowItem) {
    const HalfedgeId right = surface_->next(windows_[item->id].into);
    if (!right.valid()) return;
    for (const HalfedgeId side : {right, surface_->next(right)}) {
      windows_.fetch(edge_of(side));
      __builtin_prefetch(&surface_->lengths()[edge_of(side).index()]);
    }
  }
}

void WindowFront::march() {
  constexpr std::size_t kOfItem = 4;  // units of work
  StepQueue::Item item{};
  for (work_.report(); queue_.pop(item); work_.report()) {
    work_.add(kOfItem + windows_.take_work());
    fetch_ahead();
    if (item.kind == kVertexItem) {
      const VertexId v{item.id};
      if (item.key <= vertices_[v].distance * (1 + 1e-9)) spread_from(v);
      continue;
    }
    const EdgeWindow window = windows_[item.id];
    if (window.is_empty()) continue;
    if (const double lowest = window.lowest(); queue_.is_later(lowest)) {
      queue_.push({lowest, item.id, kWindowItem});  // the window was cut after its push
    } else {
      propagate(window);
    }
  }
}

void WindowFront::propagate(const EdgeWindow& stored) {
  const HalfedgeId into = stored.into;
  if (!surface_->has_face(into) || stored.py == 0) return;
  const FaceBeyond face(*surface_, into);
  const EdgeWindow window = laid_along(into, stored, face.length);
  const auto reached = face.reached_through(window);
  if (reached.right) add(face.through_right(window, *reached.right));
  if (reached.left) add(face.through_left(window, *reached.left));
}

/// Adds a window that is laid out along its `into`.
void WindowFront::add(const EdgeWindow& window) {
  insert(laid_along(window.into, window, surface_->length(edge_of(window.into))));
}

/// In faces without area, a point source may lie on the side of its own window. All paths of the
/// window then pass through the source point, even if only a small part of the side is nearest to
/// it. These paths are continued at once, through a stack of such faces if necessary.
void WindowFront::pass_on(const EdgeWindow& window, int most) {
  const HalfedgeId into = window.into;
  const bool through = window.px > 0 && window.px < surface_->length(edge_of(into));
  if (window.py != 0 || !through || !surface_->has_face(into) || most == 0) return;
  const FaceBeyond face(*surface_, into);
  for (const EdgeWindow& side : {face.through_right(window, {0, face.right_length}),
                                 face.through_left(window, {0, face.left_length})}) {
    add(side);
    pass_on(side, most - 1);
  }
}

/// Continues from a vertex along the edges to its neighbours. Paths along edges are seldom the
/// shortest, but they bound all distances, whatever the shapes of the triangles. Paths across faces
/// start only at sources and at vertices where a shortest path can bend.
void WindowFront::spread_from(VertexId v) {
  const NearestOnCurve from = vertices_[v];
  const HalfedgeId first = surface_->halfedge(v);
  if (!first.valid()) return;
  const bool bends = from.distance == 0 || bending_.contain(v);
  HalfedgeId h = first;
  do {
    lower(surface_->head(h), from.farther_by(surface_->length(edge_of(h))));
    if (!surface_->has_face(h)) break;
    if (bends) spread_across(h, from);
    h = surface_->turn_ccw(h);
  } while (h != first);
}

/// Adds the window of the paths from the tail of a halfedge across its face to the opposite side.
void WindowFront::spread_across(HalfedgeId spoke, const NearestOnCurve& from) {
  const HalfedgeId opposite = surface_->next(spoke), last = surface_->next(opposite);
  const double length = surface_->length(edge_of(opposite));
  const double near = surface_->length(edge_of(spoke));
  const double far = surface_->length(edge_of(last));
  // The same tests as in insert(), but before the layout of the window.
  const double same = NearestOnCurve::kSame * (length + from.distance + near);
  const double at_near = vertices_[surface_->tail(opposite)].distance;
  const double at_far = vertices_[surface_->tail(last)].distance;
  if (at_near + length + same < from.distance + far) return;
  if (at_far + length + same < from.distance + near) return;
  const PlanePoint source = apex(length, near, far);
  EdgeWindow window;
  window.end = length;
  window.px = length - source.x;
  window.py = -source.y;
  window.offset = from.distance;
  window.arc = from.arc_length;
  window.curve = from.curve;
  window.into = twin(opposite);
  add(window);
  pass_on(window);
}

/// Stores the parts of a new window that are shorter than all known distances on its edge, and
/// removes the superfluous parts of other windows. Paths continue from the ends of the new window
/// along the edge. The window must be laid out along the edge's own halfedge.
void WindowFront::insert(const EdgeWindow& window) {
  const EdgeId edge = edge_of(window.into);
  const double length = surface_->length(edge);
  const VertexId tail = surface_->tail(halfedge_of(edge));
  const VertexId head = surface_->head(halfedge_of(edge));
  const double at_begin = window.value(window.begin), at_end = window.value(window.end);
  const double same = NearestOnCurve::kSame * (length + at_begin);
  // The window is dropped if a path along the edge, from one of the edge's ends, is shorter
  // everywhere.
  if (vertices_[tail].distance + window.end + same < at_end) return;
  if (vertices_[head].distance + (length - window.begin) + same < at_begin) return;
  const double to_tail = at_begin + window.begin, to_head = at_end + (length - window.end);
  if (to_tail < vertices_[tail].distance) {
    lower(tail, {to_tail, window.curve, window.arc_at(window.begin)});
  }
  if (to_head < vertices_[head].distance) {
    lower(head, {to_head, window.curve, window.arc_at(window.end)});
  }
  if (!has_room()) return;
  const EdgeRange whole = windows_.not_longer(edge, window, length, same);
  if (whole.is_empty()) return;
  ShorterParts shorter(window, length, same, {whole.begin, whole.end});
  windows_.each_meeting(whole, edge, [&](EdgeWindow& other) {
    work_.add(1);
    shorter.compare_with(other);
    if (shorter.empty()) return EdgeRange{};
    return EdgeRange{shorter.parts().front()[0], shorter.parts().back()[1]};
  });
  for (const auto& [begin, end] : shorter.parts()) {
    EdgeWindow part = window;
    part.begin = begin;
    part.end = end;
    queue_.push({part.lowest(), windows_.add(edge, part), kWindowItem});
  }
}

/// Whether another window may be stored. If there is no room, exact_within() becomes the distance
/// of the front: the windows that are left out would change only larger distances.
bool WindowFront::has_room() {
  if (!std::isinf(exact_within_)) return false;
  const std::size_t count = windows_.size();
  const bool suffices = count < room_.windows ||
                        count - room_.windows <= room_.windows_of_edge * windows_.edge_count();
  if (suffices && count < room_.most) return true;
  exact_within_ = std::isinf(distance()) ? 0 : distance();
  return false;
}

void WindowFront::lower(VertexId v, const NearestOnCurve& way) {
  if (vertices_.lower(v, way)) {
    queue_.push({vertices_[v].distance, static_cast<std::uint32_t>(v.index()), kVertexItem});
  }
}

}  // namespace talweg

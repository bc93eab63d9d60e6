// PolylineDistance: windows spread over the surface.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

// Ways count as equally short if they differ by less than this, relative to the lengths they are
// computed from.
constexpr double kSame = 1e-13;
// Accuracy of the windows' borders, relative to the edge or to the distance of the source; the
// latter can be far shorter than the edge although its ways lead everywhere. Neighbouring windows
// overlap by a few times that, and windows narrower than kNarrow times that are dropped.
constexpr double kBorder = 1e-10;
constexpr double kNarrow = 8;

/// The smaller of the edge's length and the source's distance from the window.
double size_of(const EdgeWindow& w, double length) {
  if (!w.from_point() || w.py == 0) return length;
  return std::min(length, std::abs(w.py) + std::max({w.begin - w.px, w.px - w.end, 0.0}));
}

/// The direction from a source below the side (0, 0) - (length, 0) through the side's point b.
PlanePoint direction(const EdgeWindow& w, double b) {
  return w.from_point() ? PlanePoint{b - w.px, -w.py} : PlanePoint{w.px, w.py};
}

/// The window's source as seen from another side: origin o, direction u.
EdgeWindow seen_from(const EdgeWindow& w, PlanePoint o, PlanePoint u) {
  EdgeWindow seen = w;
  if (w.from_point()) {
    const double x = w.px - o.x, y = w.py - o.y;
    seen.px = x * u.x + y * u.y;
    seen.py = std::min(u.x * y - u.y * x, 0.0);
  } else {
    seen.px = w.px * u.x + w.py * u.y;
    seen.py = std::max(u.x * w.py - u.y * w.px, 0.0);
    seen.offset = w.offset + w.px * o.x + w.py * o.y;
    seen.arc = w.arc + w.sense * (w.py * o.x - w.px * o.y);
  }
  return seen;
}

PlanePoint unit(double x, double y, double length) {
  return length > 0 ? PlanePoint{x / length, y / length} : PlanePoint{1, 0};
}

/// a / (a + b) for a, b >= 0.
double part(double a, double b) { return a > 0 ? a / (a + b) : 0.0; }

/// Disjoint parts of an edge. When there are too many, gaps are closed, which only costs time.
struct Parts {
  std::size_t count = 0;
  std::array<std::array<double, 2>, 12> at;

  [[nodiscard]] double begin() const { return at[0][0]; }
  [[nodiscard]] double end() const { return at[count - 1][1]; }
  void add(double from, double to) {
    if (count > 0 && (from <= at[count - 1][1] || count == at.size())) {
      at[count - 1][1] = to;
    } else {
      at[count++] = {from, to};
    }
  }
  void take(const Parts& other) {
    count = other.count;
    std::copy_n(other.at.begin(), count, at.begin());
  }
};

/// Keeps the parts where `window` is below `other` or outside it; cuts off the ends of `other` that
/// lie above `window`. Narrow parts are dropped. `length` is that of the edge, `size` is the
/// window's size_of().
void keep_below(Parts& parts, const EdgeWindow& window, EdgeWindow& other, double same,
                double length, double size) {
  Parts left;
  const auto keep = [&](double from, double to) {
    if (to - from > kNarrow * kBorder * size || length <= 0) left.add(from, to);
  };
  for (std::size_t i = 0; i < parts.count; ++i) {
    const auto [begin, end] = parts.at[i];
    const double low = std::max(begin, other.begin), high = std::min(end, other.end);
    if (other.is_empty() || low > high) {
      left.add(begin, end);
      continue;
    }
    const double border = kBorder * std::min(size, size_of(other, length));
    const Stretches won = where_below(window, other, low, high, same, border);
    // If the window has won up to the end of the overlap, it continues beyond it.
    double open = begin < low ? begin : high;
    double until = begin < low ? low : high;
    bool any = begin < low;
    for (int k = 0; k < won.count; ++k) {
      const auto [from, to] = won.at[k];
      if (any && from <= until) {
        until = to;
      } else {
        if (any) keep(open, until);
        open = from;
        until = to;
        any = true;
      }
    }
    if (high < end) {
      if (any && until >= high) {
        until = end;
      } else {
        if (any) keep(open, until);
        open = high;
        until = end;
        any = true;
      }
    }
    if (any) keep(open, until);
    for (int k = 0; k < won.count; ++k)
      other.cut(won.at[k][0], won.at[k][1], 2 * border, kNarrow * border);
  }
  parts.take(left);
}

}  // namespace

/// Prefetches memory for the next items, whose windows and edges lie anywhere.
void PolylineDistance::fetch_ahead() const {
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

/// Processes all items of one step of the queue.
void PolylineDistance::march() {
  constexpr std::size_t kOfItem = 4;  // units of work
  StepQueue::Item item{};
  for (tell_work(); queue_.pop(item); tell_work()) {
    work_ += kOfItem;
    fetch_ahead();
    if (item.kind == kVertexItem) {
      const VertexId v{item.id};
      if (item.key <= vertex_[v.index()].distance * (1 + 1e-9)) spread_from(v);
      continue;
    }
    const EdgeWindow window = windows_[item.id];
    if (window.end < window.begin) continue;
    if (const double lowest = window.lowest(); queue_.is_later(lowest)) {
      queue_.push({lowest, item.id, kWindowItem});  // it has been cut since it was pushed
    } else {
      propagate(window);
    }
  }
}

/// The face that a window (whose edge runs along `into`) leads to.
PolylineDistance::Beyond PolylineDistance::beyond(HalfedgeId into) const {
  Beyond face;
  face.right = surface_->next(into);
  face.left = surface_->next(face.right);
  face.right_length = surface_->length(edge_of(face.right));
  face.left_length = surface_->length(edge_of(face.left));
  face.length = surface_->length(edge_of(into));
  face.top = apex(face.length, face.left_length, face.right_length);
  return face;
}

/// The window's source as seen through the face's right (or left) side, with the whole side as
/// extent.
EdgeWindow PolylineDistance::through_right(const EdgeWindow& window, const Beyond& face) {
  const PlanePoint a = face.top;
  EdgeWindow seen = seen_from(window, a, unit(face.length - a.x, -a.y, face.right_length));
  seen.into = twin(face.right);
  seen.begin = 0;
  seen.end = face.right_length;
  return seen;
}
EdgeWindow PolylineDistance::through_left(const EdgeWindow& window, const Beyond& face) {
  EdgeWindow seen = seen_from(window, {0, 0}, unit(face.top.x, face.top.y, face.left_length));
  seen.into = twin(face.left);
  seen.begin = 0;
  seen.end = face.left_length;
  return seen;
}

void PolylineDistance::propagate(const EdgeWindow& stored) {
  const HalfedgeId h = stored.into;
  if (!surface_->has_face(h) || stored.py == 0) return;
  const Beyond face = beyond(h);
  const double length = face.length;
  const EdgeWindow w = h == halfedge_of(edge_of(h)) ? stored : stored.turned(length);
  // Positive where the apex is to the left of the way through the window's end.
  const PlanePoint a = face.top, d0 = direction(w, w.begin), d1 = direction(w, w.end);
  const double side0 = d0.x * a.y - d0.y * (a.x - w.begin);
  const double side1 = d1.x * a.y - d1.y * (a.x - w.end);
  if (side1 > 0) {
    EdgeWindow right = through_right(w, face);
    const double all = right.end;
    if (side0 > 0) right.begin = all * part(side0, d0.y * (length - w.begin));
    right.end = all * part(side1, d1.y * (length - w.end));
    add(right);
  }
  if (side0 < 0) {
    EdgeWindow left = through_left(w, face);
    const double all = left.end;
    left.begin = all * part(d0.y * w.begin, -side0);
    if (side1 < 0) left.end = all * part(d1.y * w.end, -side1);
    add(left);
  }
}

/// Adds a window whose edge runs along `into`.
void PolylineDistance::add(const EdgeWindow& window) {
  const EdgeId edge = edge_of(window.into);
  insert(window.into == halfedge_of(edge) ? window : window.turned(surface_->length(edge)));
}

/// In faces without area, a point source may lie on the side of its own window. Then all its ways
/// pass through that one point, even if only a small part of the side is nearest to it. These ways
/// are continued at once, through a stack of such faces if necessary.
void PolylineDistance::pass_on(const EdgeWindow& window, int most) {
  const HalfedgeId h = window.into;
  const bool through = window.px > 0 && window.px < surface_->length(edge_of(h));
  if (window.py != 0 || !through || !surface_->has_face(h) || most == 0) return;
  const Beyond face = beyond(h);
  for (const EdgeWindow& side : {through_right(window, face), through_left(window, face)}) {
    add(side);
    pass_on(side, most - 1);
  }
}

/// A way leads along the edges from every vertex to its neighbours. It is seldom the shortest one,
/// but it bounds all distances whatever the triangles are like. Ways across faces start only at
/// vertices where a shortest way can bend.
void PolylineDistance::spread_from(VertexId v) {
  const Nearest from = vertex_[v.index()];
  const HalfedgeId first = surface_->halfedge(v);
  if (!first.valid()) return;
  const bool bends = from.distance == 0 || bends_at(v);
  HalfedgeId h = first;
  do {
    lower(surface_->head(h), from.distance + surface_->length(edge_of(h)), from.curve,
          from.arc_length);
    if (!surface_->has_face(h)) break;
    if (!bends) {
      h = surface_->turn_ccw(h);
      continue;
    }
    const HalfedgeId opposite = surface_->next(h), last = surface_->next(opposite);
    h = twin(last);  // the next one counterclockwise
    const double length = surface_->length(edge_of(opposite));
    const double near = surface_->length(edge_of(surface_->prev(opposite)));
    const double far = surface_->length(edge_of(last));
    // As in insert(), but before anything is laid out.
    const double same = kSame * (length + from.distance + near);
    const double at_near = vertex_[surface_->tail(opposite).index()].distance;
    const double at_far = vertex_[surface_->tail(last).index()].distance;
    if (at_near + length + same < from.distance + far) continue;
    if (at_far + length + same < from.distance + near) continue;
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
  } while (h != first);
}

void PolylineDistance::lower(VertexId v, double distance, std::uint32_t curve, double arc) {
  Nearest& known = vertex_[v.index()];
  if (!(distance < known.distance)) return;
  const bool fresh = std::isinf(known.distance);
  const bool much = fresh || distance < known.distance * (1 - kSame);
  known = {std::max(distance, 0.0), curve, arc};
  if (fresh) touched_vertices_.push_back(v);
  if (much) {
    queue_.push({known.distance, static_cast<std::uint32_t>(v.index()), kVertexItem});
  }
}

/// Whether a shortest way can bend at the vertex: its total angle exceeds a full turn (half a turn
/// at the boundary), or it has an edge of length 0.
bool PolylineDistance::bends_at(VertexId v) {
  constexpr double kSlack = 1e-7;  // radians; ways left out are longer by less than its square
  std::uint8_t& known = bends_[v.index()];
  if (known != 0) return known == 2;
  double sum = surface_->on_boundary(v) ? std::numbers::pi : 0.0;
  bool no_length = false;
  const HalfedgeId first = surface_->halfedge(v);
  HalfedgeId h = first;
  while (h.valid()) {
    const double length = surface_->length(edge_of(h));
    no_length |= length <= 0;
    if (!surface_->has_face(h)) break;
    sum += angle_between(length, surface_->length(edge_of(surface_->prev(h))),
                         surface_->length(edge_of(surface_->next(h))));
    h = surface_->turn_ccw(h);
    if (h == first) break;
  }
  known = no_length || sum > 2 * std::numbers::pi + kSlack ? 2 : 1;
  return known == 2;
}

/// Keeps the parts of a new window that are shorter than everything known on its edge, and removes
/// the parts of other windows that it makes superfluous.
void PolylineDistance::insert(const EdgeWindow& window) {
  const EdgeId edge = edge_of(window.into);
  const double length = surface_->length(edge);
  const VertexId tail = surface_->tail(halfedge_of(edge));
  const VertexId head = surface_->head(halfedge_of(edge));
  const double at_begin = window.value(window.begin), at_end = window.value(window.end);
  const double same = kSame * (length + at_begin);
  // It is longer everywhere than the way along the edge from one of its ends.
  if (vertex_[tail.index()].distance + window.end + same < at_end) return;
  if (vertex_[head.index()].distance + (length - window.begin) + same < at_begin) return;
  const double to_tail = at_begin + window.begin, to_head = at_end + (length - window.end);
  if (to_tail < vertex_[tail.index()].distance) {
    lower(tail, to_tail, window.curve, window.arc_at(window.begin));
  }
  if (to_head < vertex_[head.index()].distance) {
    lower(head, to_head, window.curve, window.arc_at(window.end));
  }

  Parts parts;
  parts.add(window.begin, window.end);
  const double size = size_of(window, length);
  windows_.each_meeting({window.begin, window.end}, edge, [&](EdgeWindow& other) {
    ++work_;
    keep_below(parts, window, other, same, length, size);
    return parts.count > 0 ? WindowLists::Range{parts.begin(), parts.end()} : WindowLists::Range{};
  });
  for (std::size_t i = 0; i < parts.count; ++i) {
    EdgeWindow part = window;
    part.begin = parts.at[i][0];
    part.end = parts.at[i][1];
    queue_.push({part.lowest(), windows_.add(edge, part), kWindowItem});
  }
}

}  // namespace talweg

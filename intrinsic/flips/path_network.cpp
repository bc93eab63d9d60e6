#include "talweg/intrinsic/flips/path_network.hpp"

#include <algorithm>
#include <cassert>

namespace talweg {
namespace {

bool along_edge(HalfedgeId h) { return h == halfedge_of(edge_of(h)); }

}  // namespace

PathNetwork::SegmentId PathNetwork::new_segment(HalfedgeId h, std::uint32_t path) {
  Segment segment;
  segment.halfedge = h;
  segment.path = path;
  segments_.push_back(segment);
  return static_cast<SegmentId>(segments_.size() - 1);
}

void PathNetwork::add(const EdgePath& path) {
  if (first_on_.size() < triangulation_->edge_count()) {
    first_on_.resize(triangulation_->edge_count(), kNone);
  }
  const auto id = static_cast<std::uint32_t>(paths_.size());
  const auto first = static_cast<SegmentId>(segments_.size());
  const auto count = static_cast<SegmentId>(path.halfedges().size());
  for (const HalfedgeId h : path.halfedges()) new_segment(h, id);
  for (SegmentId k = 0; k < count; ++k) {
    if (k > 0) segments_[first + k].prev = first + k - 1;
    if (k + 1 < count) segments_[first + k].next = first + k + 1;
  }
  if (path.closed()) {
    segments_[first].prev = first + count - 1;
    segments_[first + count - 1].next = first;
  }
  for (SegmentId k = 0; k < count; ++k) place_among(first + k);
  paths_.push_back({path.closed(), first, count, path_length(*triangulation_, path)});
}

void PathNetwork::clear() {
  for (const Segment& s : segments_) {
    if (s.alive) first_on_[edge_of(s.halfedge).index()] = kNone;
  }
  segments_.clear();
  paths_.clear();
  blocked_count_ = 0;
}

EdgePath PathNetwork::extract(std::size_t path) const {
  std::vector<HalfedgeId> halfedges;
  halfedges.reserve(paths_[path].size);
  SegmentId s = paths_[path].first;
  for (std::size_t k = 0; k < paths_[path].size; ++k, s = segments_[s].next) {
    halfedges.push_back(segments_[s].halfedge);
  }
  return {std::move(halfedges), paths_[path].closed};
}

// ---- order across an edge ----

void PathNetwork::put(SegmentId s, SegmentId left_neighbour) {
  SegmentId& first = first_on_[edge_of(segments_[s].halfedge).index()];
  const SegmentId right = left_neighbour == kNone ? first : segments_[left_neighbour].right;
  segments_[s].left = left_neighbour;
  segments_[s].right = right;
  if (right != kNone) segments_[right].left = s;
  (left_neighbour == kNone ? first : segments_[left_neighbour].right) = s;
}

void PathNetwork::put_outermost_left(SegmentId s, HalfedgeId along) {
  SegmentId last = kNone;
  if (!along_edge(along)) {
    for (SegmentId k = first_on(edge_of(along)); k != kNone; k = segments_[k].right) last = k;
  }
  put(s, last);
}

void PathNetwork::set_blocked(SegmentId s, bool blocked) {
  if (segments_[s].blocked == blocked) return;
  segments_[s].blocked = blocked;
  if (blocked) {
    ++blocked_count_;
  } else {
    --blocked_count_;
  }
}

void PathNetwork::take_off(SegmentId s) {
  set_blocked(s, false);
  Segment& segment = segments_[s];
  segment.alive = false;
  if (segment.right != kNone) segments_[segment.right].left = segment.left;
  if (segment.left != kNone) {
    segments_[segment.left].right = segment.right;
  } else {
    first_on_[edge_of(segment.halfedge).index()] = segment.right;
  }
}

PathNetwork::SegmentId PathNetwork::neighbour(SegmentId s, HalfedgeId along, Side side) const {
  const bool left = (side == Side::kLeft) == along_edge(along);
  return left ? segments_[s].left : segments_[s].right;
}

bool PathNetwork::outermost(SegmentId s, HalfedgeId along, Side side) const {
  return neighbour(s, along, side) == kNone;
}

/// Steps counterclockwise from one outgoing halfedge to another; at a boundary the count continues
/// at the other end of the fan.
std::size_t PathNetwork::turn_order(HalfedgeId from, HalfedgeId to) const {
  const SignpostTriangulation& t = *triangulation_;
  std::size_t steps = 0;
  HalfedgeId h = from;
  while (h != to) {
    ++steps;
    if (t.has_face(h)) {
      h = t.turn_ccw(h);
      continue;
    }
    for (HalfedgeId cw = t.turn_cw(h); cw.valid(); cw = t.turn_cw(cw)) h = cw;
  }
  return steps;
}

bool PathNetwork::runs_left_of(SegmentId s, SegmentId other) const {
  const bool same = segments_[s].halfedge == segments_[other].halfedge;
  const auto back = [&](SegmentId k) { return same ? segments_[k].prev : segments_[k].next; };
  const auto ahead = [&](SegmentId k) { return same ? segments_[k].next : segments_[k].prev; };
  const auto course = [&](SegmentId k) {  // the other path, in the direction of this one
    return same ? segments_[k].halfedge : twin(segments_[k].halfedge);
  };
  const std::size_t limit = segments_.size();
  SegmentId a = s, b = other;
  for (std::size_t k = 0; k < limit; ++k) {
    const SegmentId a_back = segments_[a].prev, b_back = back(b);
    if (a_back == kNone || b_back == kNone) break;
    const HalfedgeId h = segments_[a].halfedge;
    const HalfedgeId from_a = twin(segments_[a_back].halfedge), from_b = twin(course(b_back));
    if (from_a != from_b) return turn_order(h, from_a) < turn_order(h, from_b);
    a = a_back;
    b = b_back;
  }
  a = s;
  b = other;
  for (std::size_t k = 0; k < limit; ++k) {
    const SegmentId a_next = segments_[a].next, b_next = ahead(b);
    if (a_next == kNone || b_next == kNone) break;
    const HalfedgeId h = twin(segments_[a].halfedge);
    const HalfedgeId to_a = segments_[a_next].halfedge, to_b = course(b_next);
    if (to_a != to_b) return turn_order(h, to_a) > turn_order(h, to_b);
    a = a_next;
    b = b_next;
  }
  return false;
}

void PathNetwork::place_among(SegmentId s) {
  const HalfedgeId h = segments_[s].halfedge;
  SegmentId left_neighbour = kNone;
  for (SegmentId k = first_on(edge_of(h)); k != kNone; k = segments_[k].right) {
    // Left and right are exchanged if h runs against the edge.
    if (runs_left_of(s, k) == along_edge(h)) break;
    left_neighbour = k;
  }
  put(s, left_neighbour);
}

// ---- wedges ----

PathNetwork::Wedge PathNetwork::wedge(SegmentId before, Side side) const {
  const SegmentId after = segments_[before].next;
  const HalfedgeId into = twin(segments_[before].halfedge), onward = segments_[after].halfedge;
  return side == Side::kLeft ? Wedge{before, after, onward, into, side}
                             : Wedge{before, after, into, onward, side};
}

double PathNetwork::angle(const Wedge& w) const {
  if (w.out != w.back) return triangulation_->angle_ccw(w.out, w.back);
  // The inner side of a spike has the angle 0; the outer side is never cleared.
  const SegmentId out_segment = w.side == Side::kLeft ? w.after : w.before;
  const SegmentId back_segment = w.side == Side::kLeft ? w.before : w.after;
  for (SegmentId k = neighbour(out_segment, w.out, Side::kLeft); k != kNone;
       k = neighbour(k, w.out, Side::kLeft)) {
    if (k == back_segment) return 0;
  }
  return std::numeric_limits<double>::infinity();
}

bool PathNetwork::is_free(const Wedge& w) const {
  const SegmentId out_segment = w.side == Side::kLeft ? w.after : w.before;
  const SegmentId back_segment = w.side == Side::kLeft ? w.before : w.after;
  if (w.out == w.back) return neighbour(out_segment, w.out, Side::kLeft) == back_segment;
  if (!outermost(out_segment, w.out, Side::kLeft)) return false;
  if (!outermost(back_segment, w.back, Side::kRight)) return false;
  const SignpostTriangulation& t = *triangulation_;
  // The sweep may reach the boundary before `back` where lengths violate the triangle inequality.
  for (HalfedgeId h = w.out; t.has_face(h);) {
    h = t.turn_ccw(h);
    if (h == w.back) return true;
    if (occupied(edge_of(h))) return false;
  }
  return false;
}

void PathNetwork::replace(const Wedge& w, std::span<const HalfedgeId> arc,
                          std::vector<SegmentId>& ids) {
  const std::uint32_t path_id = segments_[w.before].path;
  Path& path = paths_[path_id];
  const SegmentId prev = segments_[w.before].prev, next = segments_[w.after].next;
  const bool whole = prev == w.after || w.before == w.after;  // the wedge is the whole loop
  path.length -= triangulation_->length(segments_[w.before].halfedge);
  path.size -= 1;
  take_off(w.before);
  if (w.before != w.after) {
    path.length -= triangulation_->length(segments_[w.after].halfedge);
    path.size -= 1;
    take_off(w.after);
  }
  if (first_on_.size() < triangulation_->edge_count()) {
    first_on_.resize(triangulation_->edge_count(), kNone);
  }
  ids.clear();
  for (std::size_t k = 0; k < arc.size(); ++k) {
    const HalfedgeId h = w.side == Side::kLeft ? twin(arc[arc.size() - 1 - k]) : arc[k];
    const HalfedgeId inward = w.side == Side::kLeft ? twin(h) : h;
    const SegmentId s = new_segment(h, path_id);
    put_outermost_left(s, inward);
    ids.push_back(s);
    path.length += triangulation_->length(h);
    path.size += 1;
  }
  const auto link = [&](SegmentId a, SegmentId b) {
    if (a != kNone) segments_[a].next = b;
    if (b != kNone) segments_[b].prev = a;
  };
  for (std::size_t k = 0; k + 1 < ids.size(); ++k) link(ids[k], ids[k + 1]);
  const SegmentId last = ids.empty() ? prev : ids.back();
  if (last != kNone && segments_[w.after].pinned) pin(last);
  if (whole) {
    link(ids.back(), ids.front());
  } else if (ids.empty()) {
    link(prev, next);
  } else {
    link(prev, ids.front());
    link(ids.back(), next);
  }
  if (!ids.empty() && (path.first == w.before || path.first == w.after)) {
    path.first = ids.front();
  } else if (path.first == w.before || path.first == w.after) {
    path.first = prev != kNone ? prev : next;
  }
}

void PathNetwork::restart(std::size_t path_id, HalfedgeId loop, HalfedgeId inward) {
  Path& path = paths_[path_id];
  SegmentId s = path.first;
  for (std::size_t k = 0; k < path.size; ++k) {
    take_off(s);
    s = segments_[s].next;
  }
  const SegmentId single = new_segment(loop, static_cast<std::uint32_t>(path_id));
  segments_[single].prev = segments_[single].next = single;
  put_outermost_left(single, inward);
  path = {true, single, 1, triangulation_->length(loop)};
}

}  // namespace talweg

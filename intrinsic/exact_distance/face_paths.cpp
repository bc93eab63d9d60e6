#include "talweg/intrinsic/exact_distance/face_paths.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {
namespace {

double length_of(double dx, double dy) { return std::sqrt(dx * dx + dy * dy); }

/// The fraction of the segment from p to q at its point nearest to x, in [0, 1].
double nearest_part(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double dx = q.x - p.x, dy = q.y - p.y, length = length_of(dx, dy);
  if (!(length > 0)) return 0;
  return std::clamp(((x.x - p.x) * (dx / length) + (x.y - p.y) * (dy / length)) / length, 0.0, 1.0);
}

/// The direction in which a shortest path arrives at a point in the plane.
struct Arrival {
  PlanePoint direction;      // unit direction of the path at the point; 0 at the source
  PlanePoint arc_direction;  // gradient of the arc length
};

Arrival from_point(double dx, double dy) {
  const double r = length_of(dx, dy);
  if (!(r > 0)) return {};
  return {{dx / r, dy / r}, {}};
}

/// Uses the frame of the window's edge, turned so that the face is above.
Arrival from_window(const EdgeWindow& w, double x, double rise, bool own) {
  const double turn = own ? 1 : -1;
  double bend = 0;
  if (w.bends_towards(x, rise, bend)) return from_point(turn * (x - bend), rise);
  if (w.from_point()) return from_point(turn * (x - w.px), rise + std::abs(w.py));
  return {{turn * w.px, turn * w.py}, {turn * w.arc_sign * w.py, -turn * w.arc_sign * w.px}};
}

Arrival from_segment(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double part = nearest_part(x, p, q);
  const PlanePoint foot{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  Arrival arrival = from_point(x.x - foot.x, x.y - foot.y);
  if (part > 0 && part < 1) {
    const double length = length_of(q.x - p.x, q.y - p.y);
    arrival.arc_direction = {(q.x - p.x) / length, (q.y - p.y) / length};
  }
  return arrival;
}

}  // namespace

namespace {

/// The path through a window of a side to a point in that side's frame.
NearestOnCurve through(const EnteringWindow& in, double length, PlanePoint p) {
  NearestOnCurve nearest{0, in.window.curve, 0};
  nearest.distance = in.own ? in.window.value_beyond(p.x, p.y, nearest.arc_length)
                            : in.window.value_beyond(length - p.x, -p.y, nearest.arc_length);
  return nearest;
}

/// The path from a segment in the face itself to a point in the frame of side 0.
NearestOnCurve straight_from(const PolylinePiece& segment, const SideFrame& frame, PlanePoint at) {
  const PlanePoint p = frame.at(segment.from, 0), q = frame.at(segment.to, 0);
  const double part = nearest_part(at, p, q), dx = q.x - p.x, dy = q.y - p.y;
  return {length_of(at.x - (p.x + part * dx), at.y - (p.y + part * dy)), segment.curve,
          segment.arc + part * length_of(dx, dy)};
}

}  // namespace

/// Replaces `best` by shorter paths through the windows of the sides. A path is at least as long as
/// the smallest distance of its window.
void FacePaths::offer_windows(const Corners& at, Hit& best) const {
  for (const EnteringWindow& in : windows) {
    if (in.lowest > best.nearest.distance) continue;
    const NearestOnCurve nearest = through(in, frames[in.side].length, at[in.side]);
    if (nearest.is_nearer_than(best.nearest)) best = {nearest, in.side, &in};
  }
}

void FacePaths::offer_segments(PlanePoint at, Hit& best) const {
  for (const PolylinePiece& segment : segments) {
    const NearestOnCurve nearest = straight_from(segment, frames[0], at);
    if (nearest.is_nearer_than(best.nearest)) best = {nearest, 0, nullptr, &segment};
  }
}

FacePaths::Hit FacePaths::path(std::size_t i, const Barycentric& b) const {
  if (i < 3) {
    const PlanePoint p = frames[i].at(b, i);
    return {corners[i].farther_by(length_of(p.x, p.y)), i};
  }
  i -= 3;
  if (i < windows.size()) {
    const EnteringWindow& in = windows[i];
    return {through(in, frames[in.side].length, frames[in.side].at(b, in.side)), in.side, &in};
  }
  const PolylinePiece& segment = segments[i - windows.size()];
  return {straight_from(segment, frames[0], frames[0].at(b, 0)), 0, nullptr, &segment};
}

FacePaths::Hit FacePaths::hit(const Barycentric& b) const {
  Hit best{NearestOnCurve::none()};
  Corners at;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanePoint p = at[k] = frames[k].at(b, k);
    if (corners[k].distance > best.nearest.distance) continue;
    const NearestOnCurve nearest = corners[k].farther_by(length_of(p.x, p.y));
    if (nearest.is_nearer_than(best.nearest)) best = {nearest, k};
  }
  offer_windows(at, best);
  offer_segments(at[0], best);
  best.nearest.drop_rounding(longest);
  return best;
}

FacePaths::Slopes FacePaths::slopes(const Hit& hit, const Barycentric& b,
                                    PlanePoint direction) const {
  const SideFrame& frame = frames[hit.side];
  const PlanePoint p = frame.at(b, hit.side);
  Arrival way;
  if (hit.window != nullptr) {
    const bool own = hit.window->own;
    way = from_window(hit.window->window, own ? p.x : frame.length - p.x, p.y, own);
  } else if (hit.segment != nullptr) {
    way = from_segment(p, frame.at(hit.segment->from, 0), frame.at(hit.segment->to, 0));
  } else {
    way = from_point(p.x, p.y);
  }
  const PlanePoint step = frame.at(frames[0].rates(direction), hit.side);
  return {dot(way.direction, step), dot(way.arc_direction, step)};
}

}  // namespace talweg

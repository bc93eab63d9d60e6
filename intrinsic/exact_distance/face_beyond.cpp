#include "talweg/intrinsic/exact_distance/face_beyond.hpp"

#include <algorithm>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

/// The direction from a source below the side (0, 0) - (length, 0) through the side's point x.
PlanePoint direction(const EdgeWindow& w, double x) {
  return w.from_point() ? PlanePoint{x - w.px, -w.py} : PlanePoint{w.px, w.py};
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
    seen.arc = w.arc + w.arc_sign * (w.py * o.x - w.px * o.y);
  }
  return seen;
}

PlanePoint unit(double x, double y, double length) {
  return length > 0 ? PlanePoint{x / length, y / length} : PlanePoint{1, 0};
}

/// a / (a + b) for a, b >= 0.
double part(double a, double b) { return a > 0 ? a / (a + b) : 0.0; }

}  // namespace

FaceBeyond::FaceBeyond(const Surface& surface, HalfedgeId into)
    : right(surface.next(into)),
      left(surface.next(right)),
      length(surface.length(edge_of(into))),
      right_length(surface.length(edge_of(right))),
      left_length(surface.length(edge_of(left))),
      top(apex(length, left_length, right_length)) {}

FaceBeyond::Reached FaceBeyond::reached_through(const EdgeWindow& window) const {
  const PlanePoint d0 = direction(window, window.begin), d1 = direction(window, window.end);
  // Positive where the apex is to the left of the path through the window's begin, and through its
  // end.
  const double side0 = d0.x * top.y - d0.y * (top.x - window.begin);
  const double side1 = d1.x * top.y - d1.y * (top.x - window.end);
  Reached reached;
  if (side1 > 0) {
    const double begin =
        side0 > 0 ? right_length * part(side0, d0.y * (length - window.begin)) : 0.0;
    const double end = right_length * part(side1, d1.y * (length - window.end));
    reached.right = {begin, end};
  }
  if (side0 < 0) {
    const double begin = left_length * part(d0.y * window.begin, -side0);
    const double end = side1 < 0 ? left_length * part(d1.y * window.end, -side1) : left_length;
    reached.left = {begin, end};
  }
  return reached;
}

EdgeWindow FaceBeyond::through_right(const EdgeWindow& window, const Stretch& stretch) const {
  EdgeWindow seen = seen_from(window, top, unit(length - top.x, -top.y, right_length));
  seen.into = twin(right);
  seen.begin = stretch[0];
  seen.end = stretch[1];
  return seen;
}

EdgeWindow FaceBeyond::through_left(const EdgeWindow& window, const Stretch& stretch) const {
  EdgeWindow seen = seen_from(window, {0, 0}, unit(top.x, top.y, left_length));
  seen.into = twin(left);
  seen.begin = stretch[0];
  seen.end = stretch[1];
  return seen;
}

}  // namespace talweg

// Windows made by hand, for tests.
#pragma once

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

namespace talweg::test {

/// A window on the stretch [begin, end] of an edge. Its ways come straight from (px, py), where the
/// distance is `offset`.
inline EdgeWindow window_from(double px, double py, double begin, double end, double offset = 0) {
  EdgeWindow w;
  w.begin = begin;
  w.end = end;
  w.px = px;
  w.py = py;
  w.offset = offset;
  w.into = HalfedgeId{0};
  return w;
}

/// A window of parallel ways straight up, perpendicular to its edge.
inline EdgeWindow window_upwards(double begin, double end, double offset) {
  EdgeWindow w = window_from(0, 1, begin, end, offset);
  w.arc_sign = 1;
  return w;
}

}  // namespace talweg::test

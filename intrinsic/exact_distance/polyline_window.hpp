// A window is a part of an edge with the source and the length of the paths that reach this part.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// A stretch of an edge whose points are reached by straight paths from one source, in a planar
/// layout.
///
/// The edge lies on the x axis, halfedge_of(edge) running from (0, 0) to (length, 0) with its face
/// above. The source is a point (a curve's point, or a vertex around which the path bends), or the
/// interior of one of the curve's segments, from which parallel paths lead in one direction.
/// (J. Mitchell, D. Mount, C. Papadimitriou, "The discrete geodesic problem", 1987; for polygonal
/// sources D. Bommes, L. Kobbelt, "Accurate computation of geodesic distance fields for polygonal
/// curves on triangle meshes", 2007.)
struct EdgeWindow {
  double begin = 0;  ///< along the edge; the window is empty where end < begin
  double end = 0;
  double px = 0;  ///< the source point; for a segment the unit direction of its paths
  double py = 0;
  double offset = 0;  ///< distance at the source; for a segment at (0, 0), extrapolated
  double arc = 0;     ///< arc length at the source; for a segment at (0, 0), extrapolated
  HalfedgeId into;    ///< the paths continue into the face of this halfedge
  std::uint32_t curve = 0;
  std::int32_t arc_sign = 0;  ///< 0: point; +-1: segment whose arc length grows along +-(py, -px)
  std::uint32_t next = 0;     ///< the next window in the list of the edge

  [[nodiscard]] bool from_point() const { return arc_sign == 0; }
  /// The distance at x on the edge, also where x is outside the window.
  [[nodiscard]] double value(double x) const {
    return from_point() ? offset + std::sqrt((x - px) * (x - px) + py * py) : offset + px * x;
  }
  [[nodiscard]] double arc_at(double x) const {
    return from_point() ? arc : arc + arc_sign * py * x;
  }
  [[nodiscard]] bool is_empty() const { return end < begin; }
  /// Removes the part in [from, to], except for an overlap of `overlap`, if this part reaches
  /// within `narrow` of an end of the window.
  void cut(double from, double to, double overlap, double narrow);
  /// The smallest distance in the window.
  [[nodiscard]] double lowest() const;

  /// The distance at a point (x, y) off the edge over the shortest path through the window. The
  /// point lies on the side to which the paths lead (y > 0 if `into` is the edge's own halfedge).
  /// Where the straight path misses the window, the path bends at the window's end.
  [[nodiscard]] double value_beyond(double x, double y, double& arc_length) const;

  /// Whether the path of value_beyond() bends, and at which end of the window; `rise` is |y|.
  [[nodiscard]] bool bends_towards(double x, double rise, double& at) const;

  /// The same window after a half turn of the edge about its middle.
  [[nodiscard]] EdgeWindow turned(double length) const;
};

/// Parts of an interval, in order.
struct Stretches {
  int count = 0;
  std::array<std::array<double, 2>, 2> at{};
};

/// The parts of [low, high] where window `a` is below window `b` by more than `tolerance`. The
/// borders of a part lie outside its exact borders, by at most `resolution`. The difference of two
/// distance functions on a line has at most one critical point, so there are at most two such
/// parts.
Stretches where_below(const EdgeWindow& a, const EdgeWindow& b, double low, double high,
                      double tolerance, double resolution);

}  // namespace talweg

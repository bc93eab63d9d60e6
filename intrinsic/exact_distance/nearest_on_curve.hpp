// The nearest point of a set of curves is stored as a curve, an arc length on the curve, and the
// distance.
#pragma once

#include <cstdint>
#include <limits>

namespace talweg {

struct NearestOnCurve {
  double distance = 0;      ///< mesh units; infinite where no curve can be reached
  std::uint32_t curve = 0;  ///< the curve with the nearest point; the first of several
  double arc_length = 0;    ///< the place on that curve, in [0, its length]

  /// Paths count as equally short if they differ by less than kSame, relative to the lengths from
  /// which they are computed.
  static constexpr double kSame = 1e-13;
  /// Distances below kRounding, relative to the edges nearby, are rounding errors: the point is on
  /// the curve, at distance 0.
  static constexpr double kRounding = 1e-14;

  static NearestOnCurve none() { return {std::numeric_limits<double>::infinity(), 0, 0}; }

  /// A total order, so no answer depends on the order in which paths are found.
  [[nodiscard]] bool is_nearer_than(const NearestOnCurve& other) const {
    if (distance != other.distance) return distance < other.distance;
    return curve != other.curve ? curve < other.curve : arc_length < other.arc_length;
  }
  /// The same point of the curve, seen from a place that is farther from the curve by `way`.
  [[nodiscard]] NearestOnCurve farther_by(double way) const {
    return {distance + way, curve, arc_length};
  }
  /// Sets a distance that is a rounding error to 0; `nearby` is the length of an edge nearby.
  void drop_rounding(double nearby) {
    if (distance <= kRounding * nearby) distance = 0;
  }
};

/// The nearest point of the curves seen from the place x on an edge, over the shorter of the paths
/// along the edge to its tail and its head. x is measured from the tail; `length` is the edge's
/// length.
inline NearestOnCurve along_edge(const NearestOnCurve& tail, const NearestOnCurve& head,
                                 double length, double x) {
  const NearestOnCurve from_tail = tail.farther_by(x), from_head = head.farther_by(length - x);
  return from_head.is_nearer_than(from_tail) ? from_head : from_tail;
}

}  // namespace talweg

// The nearest point of a set of curves is a curve, a place on it, and how far away it is.
#pragma once

#include <cstdint>
#include <limits>

namespace talweg {

struct NearestOnCurve {
  double distance = 0;      ///< mesh units; infinite where no curve can be reached
  std::uint32_t curve = 0;  ///< the curve with the nearest point; the first of several
  double arc_length = 0;    ///< the place on that curve, in [0, its length]

  /// Ways count as equally short if they differ by less than this, relative to the lengths they are
  /// computed from.
  static constexpr double kSame = 1e-13;
  /// Distances below this, relative to the edges nearby, are rounding: on the curve they are 0.
  static constexpr double kRounding = 1e-14;

  static NearestOnCurve none() { return {std::numeric_limits<double>::infinity(), 0, 0}; }

  /// A total order, so that no answer depends on which way was found first.
  [[nodiscard]] bool is_nearer_than(const NearestOnCurve& other) const {
    if (distance != other.distance) return distance < other.distance;
    return curve != other.curve ? curve < other.curve : arc_length < other.arc_length;
  }
  /// The same point of the curve, from a place that is `way` farther from it.
  [[nodiscard]] NearestOnCurve farther_by(double way) const {
    return {distance + way, curve, arc_length};
  }
  /// Sets what is rounding to 0; `nearby` is the length of an edge nearby.
  void drop_rounding(double nearby) {
    if (distance <= kRounding * nearby) distance = 0;
  }
};

/// The nearer of the ways along an edge of `length` from its ends to the place x from its tail.
inline NearestOnCurve along_edge(const NearestOnCurve& tail, const NearestOnCurve& head,
                                 double length, double x) {
  const NearestOnCurve from_tail = tail.farther_by(x), from_head = head.farther_by(length - x);
  return from_head.is_nearer_than(from_tail) ? from_head : from_tail;
}

}  // namespace talweg

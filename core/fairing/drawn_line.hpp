// A drawn line is a drawing in space with arc lengths, which tell the part that belongs to a
// sample.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// Places are arc lengths from the first point, mesh units. On a closed line, places that differ by
/// the length of the line are the same.
class DrawnLine {
 public:
  /// The points of a polyline in space, at least one.
  DrawnLine(std::vector<Point> points, bool closed);

  [[nodiscard]] double length() const { return arcs_.back(); }
  /// The point at a place. O(log points).
  [[nodiscard]] Point at(double arc) const;
  /// The arc length from one place to another, the shorter way on a closed line; negative
  /// backwards.
  [[nodiscard]] double between(double from, double to) const;
  /// Whether the line between two places, on the shorter way, stays within `distance` (mesh units)
  /// of the first place. O(points between the places).
  [[nodiscard]] bool stays_near(double from, double to, double distance) const;
  /// Whether the line from one place on to another stays within `distance` of the straight segment
  /// between the two places. O(points between the places).
  [[nodiscard]] bool is_straight(double from, double to, double distance) const;

 private:
  [[nodiscard]] double wrapped(double arc) const;
  template <class Look>
  bool holds_between(double from, double to, const Look& look) const;

  std::vector<Point> points_;
  std::vector<double> arcs_;  // of the points, and of the end of a closed line
  bool closed_;
};

}  // namespace talweg

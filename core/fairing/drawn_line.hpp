// A drawn line is a drawing in space, measured along it: which part of it belongs to a sample.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// Places are arc lengths from the first point, mesh units; on a closed line they may be given a
/// whole length more or less.
class DrawnLine {
 public:
  /// The points of a polyline in space, at least one.
  DrawnLine(std::vector<Point> points, bool closed);

  [[nodiscard]] double length() const { return arcs_.back(); }
  /// O(log points).
  [[nodiscard]] Point at(double arc) const;
  /// The way along the line from one place to another, the shorter one on a closed line; backwards
  /// negative.
  [[nodiscard]] double between(double from, double to) const;
  /// Whether what is drawn between two places, on the shorter way, is nowhere farther than this
  /// (mesh units) from the first. O(points between them).
  [[nodiscard]] bool stays_near(double from, double to, double distance) const;
  /// Whether what is drawn from one place on to another is nowhere farther than this from the
  /// straight line between them. O(points between them).
  [[nodiscard]] bool is_straight(double from, double to, double distance) const;

 private:
  [[nodiscard]] double wrapped(double arc) const;
  template <class Look>
  bool holds_between(double from, double to, const Look& look) const;

  std::vector<Point> points_;
  std::vector<double> arcs_;  // of the points; of a closed line also that of its end
  bool closed_;
};

}  // namespace talweg

#include "talweg/core/fairing/drawn_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/space/nearest_segment.hpp"

namespace talweg {

DrawnLine::DrawnLine(std::vector<Point> points, bool closed)
    : points_(std::move(points)), closed_(closed) {
  if (closed_) points_.push_back(points_.front());
  arcs_.reserve(points_.size());
  arcs_.push_back(0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    arcs_.push_back(arcs_.back() + (points_[i] - points_[i - 1]).norm());
  }
}

double DrawnLine::wrapped(double arc) const {
  if (!closed_ || !(length() > 0)) return std::clamp(arc, 0.0, length());
  const double rest = std::fmod(arc, length());
  return rest < 0 ? rest + length() : rest;
}

Point DrawnLine::at(double arc) const {
  const double place = wrapped(arc);
  const auto after = std::upper_bound(arcs_.begin(), arcs_.end(), place);
  if (after == arcs_.begin()) return points_.front();
  if (after == arcs_.end()) return points_.back();
  const auto i = static_cast<std::size_t>(after - arcs_.begin());
  const double part = (place - arcs_[i - 1]) / (arcs_[i] - arcs_[i - 1]);
  return points_[i - 1] + part * (points_[i] - points_[i - 1]);
}

double DrawnLine::between(double from, double to) const {
  if (!closed_ || !(length() > 0)) return to - from;
  return std::remainder(to - from, length());
}

/// Whether look() is true for all points between two places, the second ahead of the first.
template <class Look>
bool DrawnLine::holds_between(double from, double to, const Look& look) const {
  const double start = wrapped(from);
  double ahead = to - from;  // the remaining arc length from `first` on
  for (double first = start; ahead > 0; first = 0) {
    const auto begin = std::upper_bound(arcs_.begin(), arcs_.end(), first);
    const auto end = std::lower_bound(begin, arcs_.end(), first + ahead);
    for (auto at = begin; at != end; ++at) {
      if (!look(points_[static_cast<std::size_t>(at - arcs_.begin())])) return false;
    }
    if (!closed_ || end != arcs_.end()) return true;
    ahead -= length() - first;
  }
  return true;
}

bool DrawnLine::stays_near(double from, double to, double distance) const {
  const double way = between(from, to);
  if (std::abs(way) <= distance) return true;
  const Point here = at(from);
  const auto is_near = [&](const Point& p) { return (p - here).norm() <= distance; };
  return is_near(at(to)) &&
         holds_between(way < 0 ? from + way : from, way < 0 ? from : from + way, is_near);
}

bool DrawnLine::is_straight(double from, double to, double distance) const {
  if (to - from <= distance) return true;
  const Segment chord{at(from), at(to)};
  return holds_between(from, to, [&](const Point& p) { return distance_to(chord, p) <= distance; });
}

}  // namespace talweg

#include "talweg/core/fairing/drawn_band.hpp"

#include <tuple>

namespace talweg {

DrawnBand::DrawnBand(PolylineDistance& distance, const std::vector<BandCurve>& curves,
                     const DrawnLine* line)
    : distance_(&distance), line_(line) {
  for (const BandCurve& curve : curves) add(curve);
  std::sort(widths_.begin(), widths_.end(),
            [](const Width& a, const Width& b) { return a.curve < b.curve; });
  const auto wall = [](const Width& w) { return w.width.wall_in_slacks * w.width.slack; };
  for (std::size_t k = 1; k < widths_.size(); ++k) {
    if (wall(widths_[k]) < wall(widths_[narrowest_])) narrowest_ = k;
  }
}

void DrawnBand::add(const BandCurve& curve) {
  const double length = distance_->curve_length(curve.curve);
  Width& own = widths_.emplace_back(
      Width{curve.curve, curve.width, curve.begin, length, curve.reversed, {}, {}});
  const auto slack_at = std::exchange(own.width.slack_at, {});
  if (slack_at.empty()) return;
  const auto arcs = distance_->point_arcs(own.curve);
  own.arcs.assign(arcs.begin(), arcs.end());
  own.slacks.assign(slack_at.begin(), slack_at.end());
  if (distance_->curve_length(own.curve) > own.arcs.back()) {  // closed
    own.arcs.push_back(distance_->curve_length(own.curve));
    own.slacks.push_back(own.slacks.front());
  }
}

/// The width of a curve of the band; null for any other curve of the distance.
const DrawnBand::Width* DrawnBand::width_of(std::uint32_t curve) const {
  const auto at = std::lower_bound(widths_.begin(), widths_.end(), curve,
                                   [](const Width& w, std::size_t c) { return w.curve < c; });
  return at != widths_.end() && at->curve == curve ? &*at : nullptr;
}

std::pair<double, double> DrawnBand::Width::slack_at(double arc) const {
  if (slacks.size() < 2) return {std::max(width.slack, width.least_slack), 0};
  const auto after = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, arc);
  const auto i = static_cast<std::size_t>(after - arcs.begin());
  const double step = arcs[i] - arcs[i - 1];
  const double part = step > 0 ? std::clamp((arc - arcs[i - 1]) / step, 0.0, 1.0) : 0;
  const double slack = (1 - part) * slacks[i - 1] + part * slacks[i];
  if (slack < width.least_slack) return {width.least_slack, 0};
  return {slack, step > 0 ? (slacks[i] - slacks[i - 1]) / step : 0};
}

/// The least slack between two arc lengths of the curve.
double DrawnBand::Width::least_between(double from, double to) const {
  double least = std::min(slack_at(from).first, slack_at(to).first);
  const auto first = std::upper_bound(arcs.begin(), arcs.end(), from);
  for (auto at = first; at != arcs.end() && *at < to; ++at) {
    const double slack = slacks[static_cast<std::size_t>(at - arcs.begin())];
    least = std::min(least, std::max(slack, width.least_slack));
  }
  return least;
}

void DrawnBand::set_width(BandPlace& place, std::uint32_t curve, double arc,
                          double arc_slope) const {
  const Width* found = width_of(curve);
  const Width& own = found != nullptr ? *found : widths_[narrowest_];
  const BandWidth& width = own.width;
  double slack = std::max(width.slack, width.least_slack), slope = 0;
  if (found != nullptr) {
    std::tie(slack, slope) = own.slack_at(arc);
    slope *= arc_slope;
    place.arc = own.on_line(arc);
  }
  place.slack = slack;
  place.wall = width.wall_in_slacks * slack;
  place.wall_slope = width.wall_in_slacks * slope;
  place.centering = width.centering;
  if (place.wall > width.largest_wall) {
    place.wall = width.largest_wall;
    place.wall_slope = 0;
  }
}

BandPlace DrawnBand::at(const FaceCoordinates& point, PlanePoint direction) const {
  const auto value = distance_->at_face(point.face, point.barycentric, direction);
  BandPlace place{value.value, value.slope};
  set_width(place, value.curve, value.arc_length, value.arc_slope);
  // On the drawing itself the computed slopes are rounding noise; the distance grows to both sides.
  constexpr double kOnIt = 1e-6;  // slacks
  if (place.distance <= kOnIt * place.slack) {
    place.slope = 1;
    place.wall_slope = 0;
  }
  return place;
}

BandPlace DrawnBand::at(const SurfacePoint& point) const {
  const auto nearest = distance_->at(point);
  BandPlace place{nearest.distance};
  set_width(place, nearest.curve, nearest.arc_length, 0);
  return place;
}

bool DrawnBand::is_same_strand(const BandPlace& place, double drawn) const {
  return line_ == nullptr || std::isnan(place.arc) ||
         line_->stays_near(drawn, place.arc, place.wall);
}

/// The least of value(width, least slack) over the curves between two places of the line. On a ring
/// the second place may lie on the next turn.
template <class Value>
double DrawnBand::least_along(double from, double to, const Value& value) const {
  double least = HUGE_VAL;
  for (const Width& own : widths_) {
    for (const double turn : {0.0, line_ != nullptr ? line_->length() : 0.0}) {
      const double first = std::max(from - turn - own.begin, 0.0);
      const double last = std::min(to - turn - own.begin, own.length);
      if (first > last) continue;
      const double slack = own.reversed ? own.least_between(own.length - last, own.length - first)
                                        : own.least_between(first, last);
      least = std::min(least, value(own, slack));
    }
  }
  if (least < HUGE_VAL) return least;
  for (const Width& own : widths_) {  // rounding has led past the end
    least = std::min(least, value(own, own.least_between(0, own.length)));
  }
  return least;
}

bool DrawnBand::chord_cuts_off(double from, double to) const {
  constexpr double kNearly = 0.8;
  if (line_ == nullptr || std::isnan(from) || std::isnan(to)) return false;
  const double wall =
      least_along(from, to, [](const Width& own, double slack) { return own.wall_for(slack); });
  return !line_->is_straight(from, to, kNearly * wall);
}

double DrawnBand::slack_between(double from, double to) const {
  if (line_ == nullptr || std::isnan(from) || std::isnan(to)) return least_slack();
  return least_along(from, to, [](const Width&, double slack) { return slack; });
}

double DrawnBand::least_slack() const {
  double least = HUGE_VAL;
  for (const Width& own : widths_) {
    const double slack = own.slacks.empty()
                             ? own.width.slack
                             : *std::min_element(own.slacks.begin(), own.slacks.end());
    least = std::min(least, std::max(slack, own.width.least_slack));
  }
  return least;
}

double DrawnBand::largest_slack() const {
  double most = 0;
  for (const Width& own : widths_) {
    const double slack = own.slacks.empty()
                             ? own.width.slack
                             : *std::max_element(own.slacks.begin(), own.slacks.end());
    most = std::max({most, slack, own.width.least_slack});
  }
  return most;
}

}  // namespace talweg

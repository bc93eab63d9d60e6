#include "talweg/core/fairing/drawn_band.hpp"

#include <algorithm>
#include <utility>

namespace talweg {

DrawnBand::DrawnBand(PolylineDistance& distance, const std::vector<BandCurve>& curves)
    : distance_(&distance) {
  for (const BandCurve& curve : curves) add(curve);
  std::sort(widths_.begin(), widths_.end(),
            [](const Width& a, const Width& b) { return a.curve < b.curve; });
  const auto wall = [](const Width& w) { return w.width.walls * w.width.slack; };
  for (std::size_t k = 1; k < widths_.size(); ++k) {
    if (wall(widths_[k]) < wall(widths_[narrowest_])) narrowest_ = k;
  }
}

void DrawnBand::add(const BandCurve& curve) {
  Width& own = widths_.emplace_back(Width{curve.curve, curve.width, {}, {}});
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

/// Where another curve of the set is nearest, the narrowest of those that are joined.
const DrawnBand::Width& DrawnBand::width_at(std::uint32_t curve) const {
  const auto at = std::lower_bound(widths_.begin(), widths_.end(), curve,
                                   [](const Width& w, std::size_t c) { return w.curve < c; });
  return at != widths_.end() && at->curve == curve ? *at : widths_[narrowest_];
}

void DrawnBand::set_width(BandPlace& place, std::uint32_t curve, double arc,
                          double arc_slope) const {
  const Width& own = width_at(curve);
  const BandWidth& width = own.width;
  double slack = width.slack, slope = 0;
  if (own.slacks.size() > 1 && curve == own.curve) {
    const std::vector<double>&arcs = own.arcs, &slacks = own.slacks;
    const auto after = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, arc);
    const auto i = static_cast<std::size_t>(after - arcs.begin());
    const double step = arcs[i] - arcs[i - 1];
    const double part = step > 0 ? std::clamp((arc - arcs[i - 1]) / step, 0.0, 1.0) : 0;
    slack = (1 - part) * slacks[i - 1] + part * slacks[i];
    slope = step > 0 ? (slacks[i] - slacks[i - 1]) / step * arc_slope : 0;
  }
  if (slack < width.least_slack) {
    slack = width.least_slack;
    slope = 0;
  }
  place.slack = slack;
  place.wall = width.walls * slack;
  place.wall_slope = width.walls * slope;
  place.middle = width.middle;
  if (place.wall > width.most) {
    place.wall = width.most;
    place.wall_slope = 0;
  }
}

BandPlace DrawnBand::at(const FaceCoordinates& point, PlanePoint direction) const {
  const auto value = distance_->at_face(point.face, point.barycentric, direction);
  BandPlace place{value.value, value.slope};
  set_width(place, value.curve, value.arc_length, value.arc_slope);
  return place;
}

BandPlace DrawnBand::at(const SurfacePoint& point) const {
  const auto nearest = distance_->at(point);
  BandPlace place{nearest.distance};
  set_width(place, nearest.curve, nearest.arc_length, 0);
  return place;
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

}  // namespace talweg

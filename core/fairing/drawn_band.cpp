#include "talweg/core/fairing/drawn_band.hpp"

#include <algorithm>

namespace talweg {

DrawnBand::DrawnBand(PolylineDistance& distance, std::size_t curve, const BandWidth& width)
    : distance_(&distance), curve_(curve), width_(width) {
  if (width.slack_at.empty()) return;
  const auto arcs = distance.point_arcs(curve);
  arcs_.assign(arcs.begin(), arcs.end());
  slacks_.assign(width.slack_at.begin(), width.slack_at.end());
  width_.slack_at = {};
  if (distance.curve_length(curve) > arcs_.back()) {  // closed
    arcs_.push_back(distance.curve_length(curve));
    slacks_.push_back(slacks_.front());
  }
}

void DrawnBand::set_width(BandPlace& place, std::uint32_t curve, double arc,
                          double arc_slope) const {
  double slack = width_.slack, slope = 0;
  if (slacks_.size() > 1 && curve == curve_) {
    const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
    const auto i = static_cast<std::size_t>(after - arcs_.begin());
    const double step = arcs_[i] - arcs_[i - 1];
    const double part = step > 0 ? std::clamp((arc - arcs_[i - 1]) / step, 0.0, 1.0) : 0;
    slack = (1 - part) * slacks_[i - 1] + part * slacks_[i];
    slope = step > 0 ? (slacks_[i] - slacks_[i - 1]) / step * arc_slope : 0;
  }
  if (slack < width_.least_slack) {
    slack = width_.least_slack;
    slope = 0;
  }
  place.slack = slack;
  place.wall = width_.walls * slack;
  place.wall_slope = width_.walls * slope;
  if (place.wall > width_.most) {
    place.wall = width_.most;
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
  const double least =
      slacks_.empty() ? width_.slack : *std::min_element(slacks_.begin(), slacks_.end());
  return std::max(least, width_.least_slack);
}

}  // namespace talweg

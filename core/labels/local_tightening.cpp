#include "talweg/core/labels/local_tightening.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace talweg {
namespace {

constexpr double kHalved = 4,
                 kAllOfIt = 8;    // distances along the drawing, in multiples of the bound
constexpr double kAlmost = 0.97;  // times the bound: between points the deviation may be larger

/// The distance along the drawing from `arc` to the nearest of some places (ascending). `length` is
/// the length of a closed curve, infinite for open curves.
double nearest_of(const std::vector<double>& places, double arc, double length) {
  const auto behind = std::lower_bound(places.begin(), places.end(), arc);
  const double after = behind != places.end() ? *behind - arc : places.front() + length - arc;
  const double before =
      behind != places.begin() ? arc - *(behind - 1) : arc + length - places.back();
  return std::min(after, before);
}

/// The farthest point of each stretch of consecutive points beyond the bound.
std::vector<SurfacePoint> farthest_points(const SurfaceCurve& drawn,
                                          const std::vector<double>& apart, double bound) {
  std::vector<SurfacePoint> farthest;
  double most = 0;  // of the current stretch; 0 outside a stretch
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (!(apart[i] > bound)) {
      most = 0;
    } else if (most == 0) {
      farthest.push_back(drawn.points[i]);
      most = apart[i];
    } else if (apart[i] > most) {
      farthest.back() = drawn.points[i];
      most = apart[i];
    }
  }
  return farthest;
}

}  // namespace

std::vector<SurfacePoint> LocalTightening::tighten(const SurfaceCurve& drawn,
                                                   const SurfaceCurve& result, double bound,
                                                   std::span<double> slack,
                                                   const Progress& progress) {
  ProgressPoller poller(progress, "measure");
  const ScopedPoller scoped(distance_, poller);
  struct Place {
    double arc, apart;
  };
  std::vector<Place> places;
  distance_.set(std::span(&drawn, 1));
  const auto known = distance_.point_arcs(0);
  const std::vector<double> arcs(known.begin(), known.end());
  const double length = drawn.closed ? distance_.curve_length(0) : HUGE_VAL;
  for (const SurfacePoint& p : result.points) {
    const PolylineDistance::Nearest nearest = distance_.at(p);
    places.push_back({nearest.arc_length, nearest.distance});
  }
  distance_.set(std::span(&result, 1));
  std::vector<double> apart;
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    apart.push_back(distance_.at(drawn.points[i]).distance);
    places.push_back({arcs[i], apart[i]});
  }
  double most = 0;
  for (const Place& place : places) most = std::max(most, place.apart);
  std::vector<double> beyond;
  for (const Place& place : places) {
    if (place.apart >= kAlmost * std::min(most, bound)) beyond.push_back(place.arc);
  }
  std::sort(beyond.begin(), beyond.end());
  for (std::size_t i = 0; i < slack.size(); ++i) {
    const double away = nearest_of(beyond, arcs[i], length) / bound;
    slack[i] *= std::clamp(0.5 + 0.5 * (away - kHalved) / (kAllOfIt - kHalved), 0.5, 1.0);
  }
  return farthest_points(drawn, apart, bound);
}

}  // namespace talweg

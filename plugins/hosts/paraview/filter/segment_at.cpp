#include "segment_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace talweg::paraview {
namespace {

using Point = std::array<double, 3>;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// To a segment.
double distance(const Point& p, const Point& a, const Point& b) {
  double along = 0, squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    squared += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return distance(p,
                  {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
}

std::size_t nearest(const std::vector<Point>& curve, const Point& point) {
  const auto closer = [&](const Point& a, const Point& b) {
    return distance(a, point) < distance(b, point);
  };
  return static_cast<std::size_t>(std::min_element(curve.begin(), curve.end(), closer) -
                                  curve.begin());
}

}  // namespace

int segment_at(const std::vector<Point>& curve, bool closed, const std::vector<Point>& joined,
               const Point& place, double within) {
  if (curve.size() < 2 || joined.size() < 2) return -1;
  std::vector<std::size_t> passed;
  for (const Point& point : joined) passed.push_back(nearest(curve, point));
  if (!std::is_sorted(passed.begin(), passed.end())) return -1;
  const std::size_t steps = closed ? curve.size() : curve.size() - 1;
  std::size_t found = steps;
  double least = within;
  for (std::size_t k = 0; k < steps; ++k) {
    const double apart = distance(place, curve[k], curve[(k + 1) % curve.size()]);
    if (apart > least) continue;
    least = apart;
    found = k;
  }
  if (found == steps) return -1;
  const auto behind = std::upper_bound(passed.begin(), passed.end(), found);
  if (behind == passed.begin()) return static_cast<int>(joined.size()) - 1;
  return static_cast<int>(std::distance(passed.begin(), behind)) - 1;
}

}  // namespace talweg::paraview

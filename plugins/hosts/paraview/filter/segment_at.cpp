#include "segment_at.hpp"

#include <algorithm>
#include <cstddef>

#include "talweg/editing/legs.hpp"

namespace talweg::paraview {
namespace {

using editing::Vector;

/// The distance from p to the segment from a to b.
double distance(const Vector& p, const Vector& a, const Vector& b) {
  const Vector way = editing::minus(b, a), to = editing::minus(p, a);
  const double squared = editing::dot(way, way);
  const double t = squared > 0 ? std::clamp(editing::dot(to, way) / squared, 0.0, 1.0) : 0;
  return editing::length(editing::minus(to, editing::times(t, way)));
}

}  // namespace

int segment_at(const std::vector<Vector>& curve, bool closed, const std::vector<Vector>& joined,
               const Vector& place, double within) {
  if (curve.size() < 2 || joined.size() < 2) return -1;
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
  return static_cast<int>(editing::leg_at(joined, curve, closed, found)) - 1;
}

}  // namespace talweg::paraview

#include "talweg/core/smoothing/corridor_width.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr double kOfRadius = 0.25;

}  // namespace

double corridor_length(const SurfaceMesh& mesh, const SurfaceCurve& drawn) {
  const std::vector<Point> points = positions_of(mesh, drawn);
  const std::size_t n = points.size();
  Point centre = Point::Zero();
  double length = 0, largest = 0;
  for (std::size_t i = 0; i + (drawn.closed ? 0 : 1) < n; ++i) {
    const Point &p = points[i], &q = points[(i + 1) % n];
    centre += (q - p).norm() * ((p + q) / 2 - points[0]);
    length += (q - p).norm();
  }
  if (length > 0) centre /= length;
  centre += points[0];
  for (const Point& p : points) largest = std::max(largest, (p - centre).norm());
  return kOfRadius * largest;
}

double corridor_reach(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge) {
  return 2.5 * corridor_length(mesh, drawn) + 12 * edge;
}

}  // namespace talweg

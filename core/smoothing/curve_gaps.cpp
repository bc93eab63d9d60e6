#include "talweg/core/smoothing/curve_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "talweg/core/measure/local_distance.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

using PieceBox = Eigen::AlignedBox3d;

PieceBox box_of(std::span<const Point> points, double margin) {
  PieceBox box;
  for (const Point& p : points) box.extend(p);
  const Point out = Point::Constant(margin);
  return {box.min() - out, box.max() + out};
}

/// The gap from the points of one curve to the other, if it is below `limit`. The points that are
/// nearest in space come first, so the distance is needed only up to the smallest gap found so far.
double gap(const SurfaceMesh& mesh, const SurfaceCurve& from, const SurfaceCurve& to, double limit,
           std::optional<PolylineDistance>& distance, Asker& asker) {
  constexpr std::size_t kOfPoint = 16;  // units of work
  asker.did(kOfPoint * to.points.size());
  const NearParts other(mesh, std::span(&to, 1));
  struct Near {
    double through_space;
    const SurfacePoint* point;
  };
  std::vector<Near> near;
  std::vector<PieceBox> boxes;
  for (const SurfacePoint& point : from.points) {
    asker.did(kOfPoint);
    const Point p = mesh.position(point);
    const double through_space = other.distance(p);
    if (!(through_space < limit)) continue;
    near.push_back({through_space, &point});
    boxes.push_back(box_of(std::array{p}, limit));
  }
  if (near.empty()) return HUGE_VAL;
  std::sort(near.begin(), near.end(),
            [](const Near& a, const Near& b) { return a.through_space < b.through_space; });
  if (!distance) distance.emplace(mesh.surface());
  const AskedDuring asked(*distance, asker);
  distance->set(other.meeting(boxes));
  double least = HUGE_VAL;
  for (const Near& n : near) {
    if (n.through_space >= least) break;
    least = std::min(least, distance->below(std::min(limit, least), *n.point));
  }
  return least;
}

}  // namespace

std::vector<double> gaps_to_others(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                   double limit, const Progress& progress) {
  Asker asker(progress, "solve");
  std::vector<double> gaps(curves.size(), HUGE_VAL);
  std::vector<PieceBox> boxes;
  for (const SurfaceCurve& curve : curves) {
    boxes.push_back(box_of(positions_of(mesh, curve), limit / 2));
  }
  std::optional<PolylineDistance> distance;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    asker.did(curves.size());
    for (std::size_t j = i + 1; j < curves.size(); ++j) {
      if (!boxes[i].intersects(boxes[j])) continue;
      const double there = gap(mesh, curves[i], curves[j], limit, distance, asker);
      const double back = gap(mesh, curves[j], curves[i], std::min(limit, there), distance, asker);
      const double apart = std::min(there, back);
      if (!(apart < limit) || apart <= 1e-9 * limit) continue;
      gaps[i] = std::min(gaps[i], apart);
      gaps[j] = std::min(gaps[j], apart);
    }
  }
  return gaps;
}

}  // namespace talweg

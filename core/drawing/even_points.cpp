#include "talweg/core/drawing/even_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// The way from one point of the curve to the next, in a face that has both.
struct Step {
  FaceCoordinates from;
  std::array<double, 3> to{};  // in the same face
  double start = 0;            // length of the curve before the step
  double length = 0;
};

std::vector<Step> steps_of(const Surface& surface, const SurfaceCurve& curve) {
  std::vector<Step> steps;
  const std::size_t n = curve.points.size();
  double length = 0;
  for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
    const SurfacePoint &p = curve.points[k], &q = curve.points[(k + 1) % n];
    const FaceId face = common_face(surface, p, q);
    if (!face.valid()) {
      throw Error(ErrorCode::kBadCurve,
                  fmt::format("Point {} of the curve and the next lie in no common face.", k));
    }
    const FaceCoordinates from = coordinates_in(surface, p, face);
    const FaceCoordinates to = coordinates_in(surface, q, face);
    steps.push_back({from, to.barycentric, length, distance_in_face(surface, from, to)});
    length += steps.back().length;
  }
  return steps;
}

/// The number of equal steps.
std::size_t step_count(const EvenPoints& even, double length, bool closed) {
  const std::size_t least = closed ? 3 : 1;
  double steps = 0;
  if (even.count) {
    steps = static_cast<double>(*even.count) - (closed ? 0 : 1);
    if (steps < static_cast<double>(least)) {
      throw Error(ErrorCode::kBadUsage,
                  fmt::format("{} points are too few for {} curve, which needs {}.", *even.count,
                              closed ? "a closed" : "an open", closed ? 3 : 2));
    }
  } else {
    if (!(even.spacing > 0)) {
      throw Error(ErrorCode::kBadUsage, "The spacing of points must be above 0.");
    }
    steps = std::max(static_cast<double>(least), std::round(length / even.spacing));
  }
  if (!(steps < static_cast<double>(kMostEvenPoints))) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("A curve of length {:.6g} would get more than {} points.", length,
                            kMostEvenPoints));
  }
  return static_cast<std::size_t>(steps);
}

void add_point(const SurfaceMesh& mesh, const Step& step, double t, PlacedCurve& curve) {
  FaceCoordinates at = step.from;
  for (std::size_t k = 0; k < 3; ++k) {
    at.barycentric[k] = (1 - t) * step.from.barycentric[k] + t * step.to[k];
  }
  const SurfacePoint point =
      SurfacePoint::from_barycentric(mesh.surface(), at.face, at.barycentric);
  const auto* corner = std::get_if<AtVertex>(&point.where());
  curve.vertices.push_back(corner == nullptr ? VertexId{} : corner->vertex);
  curve.faces.push_back(at);
  curve.positions.push_back(mesh.position(point));
}

}  // namespace

ResampledCurve resampled(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                         const EvenPoints& even) {
  if (curve.points.size() < 2) {
    throw Error(ErrorCode::kBadCurve, "A curve with fewer than two points has no length.");
  }
  const std::vector<Step> steps = steps_of(mesh.surface(), curve);
  const double length = steps.back().start + steps.back().length;
  const std::size_t count = step_count(even, length, curve.closed);
  ResampledCurve result;
  result.curve.closed = curve.closed;
  result.spacing = length / static_cast<double>(count);
  std::size_t k = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = result.spacing * static_cast<double>(i);
    while (k + 1 < steps.size() && steps[k + 1].start <= at) ++k;
    const double t = steps[k].length > 0 ? (at - steps[k].start) / steps[k].length : 0;
    add_point(mesh, steps[k], std::clamp(t, 0.0, 1.0), result.curve);
  }
  if (!curve.closed) add_point(mesh, steps.back(), 1, result.curve);
  return result;
}

}  // namespace talweg

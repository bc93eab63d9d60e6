// Curve segments are the pieces of a curve between consecutive points, each inside one face.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A segment of a curve inside a face.
struct CurveSegment {
  FaceId face;                   ///< a face that contains the segment
  std::array<double, 3> from{};  ///< barycentric coordinates of one end
  std::array<double, 3> to{};    ///< barycentric coordinates of the other end
  double length = 0;             ///< mesh units

  /// The point at t, from 0 at `from` to 1 at `to`.
  [[nodiscard]] std::array<double, 3> at(double t) const {
    std::array<double, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) b[k] = (1 - t) * from[k] + t * to[k];
    return b;
  }
  [[nodiscard]] SurfacePoint point(const Surface& surface, double t) const {
    return SurfacePoint::from_barycentric(surface, face, at(t));
  }
};

/// The segment between two points of a face. Throws Error(kBadCurve) if the face does not contain
/// both. O(1).
inline CurveSegment segment_between(const Surface& surface, const SurfacePoint& p,
                                    const SurfacePoint& q, FaceId face) {
  const FaceCoordinates a = coordinates_in(surface, p, face), b = coordinates_in(surface, q, face);
  return {face, a.barycentric, b.barycentric, distance_in_face(surface, a, b)};
}

/// The segments of all curves, without segments between equal points. Throws Error(kBadCurve) with
/// the first point that shares no face with the next point. O(points · degree).
inline std::vector<CurveSegment> segments_of(const Surface& surface,
                                             std::span<const SurfaceCurve> curves) {
  std::vector<CurveSegment> segments;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < points.size(); ++i) {
      const SurfacePoint &p = points[i], &q = points[(i + 1) % points.size()];
      if (p == q) continue;
      const FaceId face = common_face(surface, p, q);
      if (!face.valid()) {
        throw Error(ErrorCode::kBadCurve, "Point " + std::to_string(i) + " of curve " +
                                              std::to_string(c) + " and the next share no face.");
      }
      segments.push_back(segment_between(surface, p, q, face));
    }
  }
  return segments;
}

}  // namespace talweg

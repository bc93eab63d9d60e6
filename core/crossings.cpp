#include "talweg/core/crossings.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

struct FaceSegment {
  FaceId face;
  std::size_t curve;
  std::array<double, 3> from, to;  // barycentrics
};

double orient(const std::array<double, 3>& a, const std::array<double, 3>& b,
              const std::array<double, 3>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const FaceSegment& p, const FaceSegment& q) {
  constexpr double kTouch = 1e-12;  // of the face
  const auto apart = [](double a, double b) {
    return (a > kTouch && b < -kTouch) || (a < -kTouch && b > kTouch);
  };
  return apart(orient(p.from, p.to, q.from), orient(p.from, p.to, q.to)) &&
         apart(orient(q.from, q.to, p.from), orient(q.from, q.to, p.to));
}

std::vector<FaceSegment> segments_by_face(const Surface& surface,
                                          std::span<const SurfaceCurve> curves) {
  std::vector<FaceSegment> segments;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < points.size(); ++i) {
      const SurfacePoint &p = points[i], &q = points[(i + 1) % points.size()];
      const FaceId face = common_face(surface, p, q);
      if (!face.valid()) {
        throw Error(ErrorCode::kBadCurve,
                    "Segment " + std::to_string(i + 1) + " of the curve lies in no face.");
      }
      segments.push_back({face, c, coordinates_in(surface, p, face).barycentric,
                          coordinates_in(surface, q, face).barycentric});
    }
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.face < b.face; });
  return segments;
}

}  // namespace

std::vector<std::size_t> crossing_curves(const Surface& surface,
                                         std::span<const SurfaceCurve> curves) {
  const std::vector<FaceSegment> segments = segments_by_face(surface, curves);
  std::vector<std::size_t> crossing;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = i + 1; k < segments.size() && segments[k].face == segments[i].face; ++k) {
      if (!cross(segments[i], segments[k])) continue;
      crossing.push_back(segments[i].curve);
      crossing.push_back(segments[k].curve);
    }
  }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return crossing;
}

}  // namespace talweg

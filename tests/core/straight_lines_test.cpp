#include "talweg/core/straight_lines.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using namespace test;

void expect_joined(const Surface& surface, const SurfaceCurve& curve) {
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < curve.points.size(); ++i) {
    EXPECT_TRUE(
        common_face(surface, curve.points[i], curve.points[(i + 1) % curve.points.size()]).valid())
        << i;
  }
}

TEST(StraightLines, PointsAsNearToEdgesAndVerticesAsRounding) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(6, 6));
  const Surface& surface = mesh.surface();
  StraightLines lines(surface);
  for (const double e : {1e-11, 1e-13, 1e-16}) {
    // One in each face of the sheet, near each corner and each side: lines leave them every way.
    std::vector<SurfacePoint> points;
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
      const FaceId face{(f * 29) % surface.face_count()};
      points.push_back(SurfacePoint::in_face(surface, face, {1 - 2 * e, e, e}));
      points.push_back(SurfacePoint::in_face(surface, face, {e, 0.5, 0.5 - e}));
      points.push_back(SurfacePoint::in_face(surface, face, {0.5, e, 0.5 - e}));
    }
    expect_joined(surface, lines.join(points, true));
  }
}

}  // namespace
}  // namespace talweg

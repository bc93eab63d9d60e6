// The curve of a chain, for circles inside one face and across two faces.
#include "talweg/core/fairing/chain_curve.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// Two triangles that make a square of 10.
SurfaceMesh square() {
  MeshLists lists;
  lists.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  lists.triangles = {{0, 1, 2}, {0, 2, 3}};
  return SurfaceMesh::open(lists);
}

/// A circle as a chain; a circle around a point of the diagonal crosses the diagonal twice.
SampleChain circle_around(ChainMaker& maker, double x0, double y0) {
  constexpr int kPoints = 64;
  SurfaceCurve circle{true, {}};
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPoints;
    const double x = x0 + std::cos(angle);
    double y = y0 + std::sin(angle);
    if (std::abs(x - y) < 1e-12) y = x;
    const std::array<double, 3> below{1 - x / 10, (x - y) / 10, y / 10};
    const std::array<double, 3> above{1 - y / 10, x / 10, (y - x) / 10};
    circle.points.push_back(SurfacePoint::from_barycentric(
        maker.surface(), FaceId{x >= y ? 0U : 1U}, x >= y ? below : above));
  }
  return *maker.sampled(trace_of(maker.surface(), circle, {}), 1.0 / 6);
}

void expect_circle(double x0, double y0) {
  const SurfaceMesh mesh = square();
  ChainMaker maker(mesh.surface());
  const SurfaceCurve curve = curve_of(mesh.surface(), maker, circle_around(maker, x0, y0), 1);
  ASSERT_GE(curve.points.size(), 3U);
  const CurveMeasures measures = measure_curve(mesh.surface(), curve);
  EXPECT_NEAR(measures.length, 2 * std::numbers::pi, 0.1);
  EXPECT_NEAR(measures.total_curvature, 2 * std::numbers::pi, 1e-9);
}

TEST(ChainCurve, ALoopInsideOneFaceIsACurve) { expect_circle(7, 2.5); }

TEST(ChainCurve, ALoopThatCrossesOneEdgeTwiceIsACurve) { expect_circle(5, 5); }

}  // namespace
}  // namespace talweg

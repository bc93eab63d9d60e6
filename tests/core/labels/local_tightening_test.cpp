// The slack is reduced near stretches beyond the bound only.
#include "talweg/core/labels/local_tightening.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {
namespace {

/// Squares of side 1: vertex (x, y) has the number y (columns + 1) + x.
constexpr std::size_t kCells = 40, kRows = 10;

VertexId vertex_at(std::size_t x, std::size_t y) { return VertexId{y * (kCells + 1) + x}; }

/// Along y = 4, but between two columns along y = height; by way of the vertical edges.
SurfaceCurve step(const Surface& surface, std::size_t from, std::size_t to, std::size_t height) {
  SurfaceCurve curve;
  const auto add = [&](std::size_t x, std::size_t y) {
    curve.points.push_back(SurfacePoint::at_vertex(surface, vertex_at(x, y)));
  };
  for (std::size_t x = 0; x <= kCells; ++x) {
    for (std::size_t y = 4; x == from && y < height; ++y) add(x, y);
    add(x, x >= from && x <= to ? height : 4);
    for (std::size_t y = height; x == to && y > 4;) add(x, --y);
  }
  return curve;
}

class LocalTighteningOnASheet : public testing::Test {
 protected:
  const SurfaceMesh mesh_ = SurfaceMesh::open(test::grid(kCells, kRows));
  const SurfaceCurve straight_ = step(mesh_.surface(), kCells + 1, 0, 4);
  LocalTightening tightening_{mesh_.surface()};
};

TEST_F(LocalTighteningOnASheet, HalvesTheSlackBesideTheStretchOnly) {
  // The result leaves the drawing, which is straight, by 2 from x = 18 to 22.
  const SurfaceCurve bump = step(mesh_.surface(), 18, 22, 6);
  for (const double bound : {0.5, 1.5}) {
    SCOPED_TRACE(bound);
    std::vector<double> slack(straight_.points.size(), 3.0);
    const auto farthest = tightening_.tighten(straight_, bump, bound, slack);
    // The drawing's points 18 to 22 are 2 from the bump or less, those between the most.
    for (std::size_t x = 0; x <= kCells; ++x) {
      const double away = x < 18 ? 18.0 - double(x) : x > 22 ? double(x) - 22 : 0;
      if (away <= 4 * bound) {
        EXPECT_EQ(slack[x], 1.5) << x;
      }
      if (away >= 8 * bound) {
        EXPECT_EQ(slack[x], 3.0) << x;
      }
      EXPECT_GE(slack[x], 1.5);
      EXPECT_LE(slack[x], 3.0);
    }
    ASSERT_EQ(farthest.size(), 1U);
    EXPECT_EQ(farthest.front(), SurfacePoint::at_vertex(mesh_.surface(), vertex_at(20, 4)));
  }
}

TEST_F(LocalTighteningOnASheet, SeesWhereTheDrawingIsCutOff) {
  const SurfaceCurve bump = step(mesh_.surface(), 18, 22, 6);
  std::vector<double> slack(bump.points.size(), 1.0);
  const auto farthest = tightening_.tighten(bump, straight_, 1, slack);
  EXPECT_EQ(slack.front(), 1.0);
  EXPECT_EQ(slack.back(), 1.0);
  EXPECT_EQ(slack[22], 0.5);  // in the middle of the bump's top
  ASSERT_EQ(farthest.size(), 1U);
  EXPECT_EQ(farthest.front(), SurfacePoint::at_vertex(mesh_.surface(), vertex_at(18, 6)));
}

TEST_F(LocalTighteningOnASheet, WithinTheBoundTakesTheFarthestAndPinsNothing) {
  const SurfaceCurve bump = step(mesh_.surface(), 18, 22, 6);
  std::vector<double> slack(straight_.points.size(), 1.0);
  EXPECT_TRUE(tightening_.tighten(straight_, bump, 2.5, slack).empty());
  EXPECT_EQ(slack[20], 0.5);
}

}  // namespace
}  // namespace talweg

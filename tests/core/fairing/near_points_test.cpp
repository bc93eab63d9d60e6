// Points close to their neighbours are dropped if a face holds both neighbours.
#include "talweg/core/fairing/near_points.hpp"

#include <array>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

class NearPointsTest : public testing::Test {
 protected:
  [[nodiscard]] const Surface& surface() const { return opened->mesh().surface(); }
  /// A point inside face 0, close to a corner.
  [[nodiscard]] SurfacePoint near_corner(std::size_t corner, double away) const {
    std::array<double, 3> barycentric{away, away, away};
    barycentric[corner] = 1 - 2 * away;
    return SurfacePoint::in_face(surface(), FaceId{0}, barycentric);
  }
  [[nodiscard]] SurfacePoint corner(std::size_t number) const {
    HalfedgeId h = surface().halfedge(FaceId{0});
    for (std::size_t k = 0; k < number; ++k) h = surface().next(h);
    return SurfacePoint::at_vertex(surface(), surface().tail(h));
  }
  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(4, 4));
};

TEST_F(NearPointsTest, AmongPointsNearAVertexTheVertexIsKept) {
  std::vector<KeptPoint> points{{corner(0), 0, true},
                                {near_corner(1, 1e-9), 1 - 1e-9},
                                {corner(1), 1},
                                {near_corner(1, 2e-9), 1 + 2e-9},
                                {corner(2), 2, true}};
  drop_near_points(surface(), false, 2, 1e-6, points);
  ASSERT_EQ(points.size(), 3);
  EXPECT_EQ(points[1].point, corner(1));
}

TEST_F(NearPointsTest, KeptAndFarPointsStay) {
  std::vector<KeptPoint> points{{corner(0), 0, true},
                                {near_corner(0, 1e-9), 1e-9, true},
                                {near_corner(1, 0.1), 0.9},
                                {corner(2), 2, true}};
  drop_near_points(surface(), false, 2, 1e-6, points);
  EXPECT_EQ(points.size(), 4);
}

TEST_F(NearPointsTest, ALoopIsCheckedAcrossItsFirstPoint) {
  std::vector<KeptPoint> points{
      {near_corner(0, 1e-9), 0}, {corner(1), 1}, {corner(2), 2}, {corner(0), 3 - 1e-9}};
  drop_near_points(surface(), true, 3, 1e-6, points);
  ASSERT_EQ(points.size(), 3);
  EXPECT_EQ(points.back().point, corner(0));
}

TEST_F(NearPointsTest, APointStaysIfNoFaceHoldsBothNeighbours) {
  // From one face over a vertex into a face that shares only this vertex with the first.
  const auto at = [&](std::uint32_t id) {
    return SurfacePoint::at_vertex(surface(), VertexId{id});
  };
  std::vector<KeptPoint> points{{at(6), 0, true}, {at(12), 1e-9}, {at(18), 1, true}};
  drop_near_points(surface(), false, 1, 1e-6, points);
  EXPECT_EQ(points.size(), 3);
}

}  // namespace
}  // namespace talweg

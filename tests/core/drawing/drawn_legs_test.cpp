// The part of a curve between two way-points is a leg, unless it has painted points.
#include "talweg/core/drawing/drawn_legs.hpp"

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"

namespace talweg {
namespace {

using Legs = std::vector<bool>;

class DrawnLegsTest : public testing::Test {
 protected:
  [[nodiscard]] SurfacePoint at(std::uint32_t v) const {
    return SurfacePoint::at_vertex(surface, VertexId{v});
  }
  [[nodiscard]] std::vector<WayPoint> exact(std::initializer_list<std::uint32_t> ids) const {
    std::vector<WayPoint> points;
    for (const std::uint32_t v : ids) points.push_back({at(v), v / 100.0});
    return points;
  }

  const Surface surface = test::surface_of_lists(test::grid(6, 6));  // rows of 7 vertices
  const SurfaceCurve row = test::vertex_curve(surface, test::ids({0, 1, 2, 3, 4, 5, 6}), false);
  const SurfaceCurve ring =
      test::vertex_curve(surface, test::ids({8, 9, 10, 17, 24, 23, 22, 15}), true);
};

TEST_F(DrawnLegsTest, WithoutWayPointsThereIsNoLeg) {
  const DrawnLegs legs = legs_of(row, {}, {}, {});
  EXPECT_FALSE(legs.any());
  EXPECT_FALSE(legs.all());
}

TEST_F(DrawnLegsTest, BetweenTheFirstAndTheLastWayPoint) {
  const DrawnLegs legs = legs_of(row, {}, exact({2, 4}), {});
  EXPECT_EQ(legs.is_leg, (Legs{false, true, false}));
  EXPECT_EQ(legs.fixed, (std::vector{at(0), at(2), at(4), at(6)}));
  EXPECT_EQ(legs.tolerances, (std::vector{0.0, 0.02, 0.04, 0.0}));
  EXPECT_TRUE(legs.any());
  EXPECT_FALSE(legs.all());
  EXPECT_TRUE(legs_of(row, {}, exact({0, 6}), {}).all());
}

TEST_F(DrawnLegsTest, PinsDivideLegs) {
  const DrawnLegs legs = legs_of(row, std::vector{at(3)}, exact({0, 6}), {});
  EXPECT_EQ(legs.is_leg, (Legs{true, true}));
  const DrawnLegs painted = legs_of(row, std::vector{at(3)}, exact({0, 4, 6}), std::vector{at(1)});
  EXPECT_EQ(painted.is_leg, (Legs{false, false, true}));
}

TEST_F(DrawnLegsTest, OneWayPointMakesNoLeg) {
  EXPECT_FALSE(legs_of(row, {}, exact({3}), {}).any());
}

TEST_F(DrawnLegsTest, LoopsNeedThreeWayPoints) {
  EXPECT_FALSE(legs_of(ring, {}, exact({8, 24}), {}).any());
  EXPECT_EQ(legs_of(ring, {}, exact({10, 24, 22}), {}).is_leg, (Legs{true, true, true}));
  // The stretch that passes the first point of the loop is last.
  EXPECT_EQ(legs_of(ring, {}, exact({10, 24, 22}), std::vector{at(8)}).is_leg,
            (Legs{true, true, false}));
}

}  // namespace
}  // namespace talweg

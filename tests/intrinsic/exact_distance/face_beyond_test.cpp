// Windows across one face, half of the unit square, with the corners (0, 0), (1, 0) and (1, 1).
#include "talweg/intrinsic/exact_distance/face_beyond.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/exact_distance/made_windows.hpp"
#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

using test::window_from;
using test::window_upwards;

class BeyondTheBase : public testing::Test {
 protected:
  const Surface surface_ = test::surface_of(test::grid(1, 1));
  const HalfedgeId base_ = surface_.find_halfedge(VertexId{0}, VertexId{1});
  const FaceBeyond face_{surface_, base_};
  const double diagonal_ = std::sqrt(2.0);
};

TEST_F(BeyondTheBase, TheApexIsLaidOutAbove) {
  EXPECT_EQ(face_.length, 1);
  EXPECT_EQ(face_.right_length, 1);
  EXPECT_DOUBLE_EQ(face_.left_length, diagonal_);
  EXPECT_DOUBLE_EQ(face_.top.x, 1);
  EXPECT_DOUBLE_EQ(face_.top.y, 1);
  EXPECT_EQ(surface_.tail(face_.right), VertexId{1});
  EXPECT_EQ(surface_.tail(face_.left), VertexId{3});
}

// A window from (0.5, -0.5): straight up through 0.5 to (0.5, 0.5), and through 0.75 to (1, 0.5).
TEST_F(BeyondTheBase, AWindowBelowTheApexReachesBothSides) {
  const auto reached = face_.reached_through(window_from(0.5, -0.5, 0.5, 0.75));
  ASSERT_TRUE(reached.right && reached.left);
  EXPECT_NEAR((*reached.right)[0], 0, 1e-15);  // at the apex
  EXPECT_NEAR((*reached.right)[1], 0.5, 1e-15);
  EXPECT_NEAR((*reached.left)[0], diagonal_ / 2, 1e-15);
  EXPECT_NEAR((*reached.left)[1], diagonal_, 1e-15);
}

TEST_F(BeyondTheBase, AWindowBesideTheApexReachesOneSide) {
  const auto left = face_.reached_through(window_upwards(0.25, 0.5, 1));
  EXPECT_FALSE(left.right);
  ASSERT_TRUE(left.left);
  EXPECT_NEAR((*left.left)[0], diagonal_ / 4, 1e-15);
  EXPECT_NEAR((*left.left)[1], diagonal_ / 2, 1e-15);
  // A window from (-4, -1): through 0.5 to (1, 1/9), and through 1.
  const auto right = face_.reached_through(window_from(-4, -1, 0.5, 1));
  EXPECT_FALSE(right.left);
  ASSERT_TRUE(right.right);
  EXPECT_NEAR((*right.right)[0], 8.0 / 9, 1e-15);
  EXPECT_NEAR((*right.right)[1], 1, 1e-15);
}

TEST_F(BeyondTheBase, DistancesAreTheSameSeenThroughASide) {
  const EdgeWindow point = window_from(0.5, -0.5, 0, 1, 3);
  const EdgeWindow right = face_.through_right(point, {0, 1});
  EXPECT_EQ(right.into, twin(face_.right));
  EXPECT_LT(right.py, 0);
  EXPECT_NEAR(right.value(0.25), 3 + std::hypot(0.5, 1.25), 1e-15);  // at (1, 0.75)
  const EdgeWindow left = face_.through_left(point, {0, diagonal_});
  EXPECT_EQ(left.into, twin(face_.left));
  EXPECT_NEAR(left.value(diagonal_ / 2), 4, 1e-15);  // at (0.5, 0.5)

  const EdgeWindow upwards = face_.through_left(window_upwards(0, 1, 3), {0, diagonal_});
  EXPECT_NEAR(upwards.value(diagonal_ / 4), 3.25, 1e-15);  // at (0.25, 0.25)
  EXPECT_NEAR(upwards.arc_at(diagonal_ / 4), 0.25, 1e-15);
}

TEST_F(BeyondTheBase, WindowsAreLaidAlongTheOtherHalfedgeByATurn) {
  const EdgeWindow w = window_from(0.25, -1, 0, 0.5);
  const HalfedgeId own = halfedge_of(edge_of(base_));
  EXPECT_EQ(laid_along(own, w, 1).px, 0.25);
  EXPECT_EQ(laid_along(twin(own), w, 1).px, 0.75);
  EXPECT_EQ(laid_along(twin(own), w, 1).py, 1);
}

}  // namespace
}  // namespace talweg

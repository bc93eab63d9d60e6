// The parts of a new window that are shorter than older ones, on an edge of length 4.
#include "talweg/intrinsic/exact_distance/shorter_parts.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/exact_distance/made_windows.hpp"

namespace talweg {
namespace {

using test::window_from;

constexpr double kLength = 4;
constexpr double kBorders = 100 * ShorterParts::kBorder * kLength;

TEST(ShorterParts, AreTheWholeWindowOnAnEmptyEdge) {
  const EdgeWindow fresh = window_from(1, -1, 0.5, 3);
  ShorterParts shorter(fresh, kLength, 0);
  EdgeWindow apart = window_from(0, -0.1, 3.5, 4);
  shorter.compare_with(apart);
  ASSERT_EQ(shorter.parts().size(), 1U);
  EXPECT_EQ(shorter.parts()[0], (ShorterParts::Part{0.5, 3}));
  EXPECT_EQ(apart.begin, 3.5);
}

TEST(ShorterParts, EndAtEqualDistanceAndCutTheOtherWindow) {
  const EdgeWindow fresh = window_from(0, -1, 0, 4);
  EdgeWindow other = window_from(4, -1, 0, 4);
  ShorterParts shorter(fresh, kLength, 0);
  shorter.compare_with(other);
  ASSERT_EQ(shorter.parts().size(), 1U);
  EXPECT_NEAR(shorter.parts()[0][1], 2, kBorders);
  EXPECT_NEAR(other.begin, 2, kBorders);
  EXPECT_EQ(other.end, 4);
  EXPECT_GE(shorter.parts()[0][1], other.begin);  // no gap between the two
}

TEST(ShorterParts, AreTwoIfAnotherWindowIsShorterInside) {
  const double r = std::sqrt(105.0) / 8;  // as in WhereBelow
  const EdgeWindow fresh = window_from(2, -2, 0, 4);
  EdgeWindow other = window_from(2, -0.5, 0, 4, 1);
  ShorterParts shorter(fresh, kLength, 0);
  shorter.compare_with(other);
  ASSERT_EQ(shorter.parts().size(), 2U);
  EXPECT_NEAR(shorter.parts()[0][1], 2 - r, kBorders);
  EXPECT_NEAR(shorter.parts()[1][0], 2 + r, kBorders);
  EXPECT_NEAR(other.begin, 2 - r, kBorders);
  EXPECT_NEAR(other.end, 2 + r, kBorders);
}

TEST(ShorterParts, InsideAnotherWindowLeaveItWhole) {
  const double r = std::sqrt(105.0) / 8;
  const EdgeWindow fresh = window_from(2, -0.5, 0, 4, 1);
  EdgeWindow other = window_from(2, -2, 0, 4);
  ShorterParts shorter(fresh, kLength, 0);
  shorter.compare_with(other);
  ASSERT_EQ(shorter.parts().size(), 1U);
  EXPECT_NEAR(shorter.parts()[0][0], 2 - r, kBorders);
  EXPECT_NEAR(shorter.parts()[0][1], 2 + r, kBorders);
  EXPECT_EQ(other.begin, 0);
  EXPECT_EQ(other.end, 4);
}

TEST(ShorterParts, AreEmptyForAnEqualWindow) {
  const EdgeWindow fresh = window_from(1, -1, 0, 4);
  EdgeWindow other = fresh;
  ShorterParts shorter(fresh, kLength, 1e-13);
  shorter.compare_with(other);
  EXPECT_TRUE(shorter.empty());
  EXPECT_FALSE(other.is_empty());
}

}  // namespace
}  // namespace talweg

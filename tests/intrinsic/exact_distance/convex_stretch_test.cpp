// The stretches of a line where a convex function is below a limit, compared with closed forms.
#include "talweg/intrinsic/exact_distance/convex_stretch.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace talweg {
namespace {

/// The distance from a line to a point at `px` along it and `py` off it.
auto to_point(double px, double py) {
  return [px, py](double x) { return std::hypot(x - px, py); };
}

TEST(ConvexStretch, IsWhereADiscMeetsALine) {
  for (const double py : {0.0, 0.3, 1.9}) {
    for (const double px : {-1.0, 0.0, 2.5, 5.0, 6.0}) {
      const auto stretch = stretch_below(to_point(px, py), 5, 2);
      const double half = std::sqrt(4 - py * py);
      const double from = std::max(0.0, px - half), to = std::min(5.0, px + half);
      ASSERT_EQ(stretch.has_value(), from <= to) << px << " " << py;
      if (!stretch) continue;
      EXPECT_NEAR(stretch->from, from, 1e-13);
      EXPECT_NEAR(stretch->to, to, 1e-13);
    }
  }
}

TEST(ConvexStretch, IsFoundHoweverShort) {
  for (const double depth : {1e-3, 1e-6, 1e-9}) {
    const double half = std::sqrt(4 - (2 - depth) * (2 - depth));
    const auto stretch = stretch_below(to_point(1.234, 2 - depth), 5, 2);
    ASSERT_TRUE(stretch.has_value()) << depth;
    EXPECT_NEAR(stretch->from, 1.234 - half, 1e-6 * half);
    EXPECT_NEAR(stretch->to, 1.234 + half, 1e-6 * half);
    EXPECT_FALSE(stretch_below(to_point(1.234, 2 + depth), 5, 2).has_value()) << depth;
  }
}

TEST(ConvexStretch, IsEmptyAboveTheLimit) {
  const auto far = [](double) { return std::numeric_limits<double>::infinity(); };
  EXPECT_FALSE(stretch_below(far, 5, 2).has_value());
}

TEST(ConvexStretch, IsCutOffAtTheEndsOfTheLine) {
  const auto rising = [](double x) { return 1 + x / 2; };
  const auto stretch = stretch_below(rising, 5, 2);
  ASSERT_TRUE(stretch.has_value());
  EXPECT_EQ(stretch->from, 0);
  EXPECT_NEAR(stretch->to, 2, 1e-13);
  EXPECT_FALSE(stretch_below(rising, 5, 0.9).has_value());
  EXPECT_EQ(stretch_below(rising, 5, 9)->to, 5);
}

TEST(ConvexStretch, StretchesThatMeetAreJoined) {
  const auto joined = joined_stretches({{3, 4}, {0, 1}, {0.5, 2}, {2.001, 2.5}, {3.2, 3.5}}, 0.01);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(joined[0].from, 0);
  EXPECT_EQ(joined[0].to, 2.5);
  EXPECT_EQ(joined[1].from, 3);
  EXPECT_EQ(joined[1].to, 4);
  EXPECT_TRUE(joined_stretches({}, 1).empty());
}

}  // namespace
}  // namespace talweg

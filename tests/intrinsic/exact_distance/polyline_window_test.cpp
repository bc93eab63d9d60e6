// One window made by hand: its values on the edge and beyond, turns, cuts and comparisons.
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/exact_distance/made_windows.hpp"

namespace talweg {
namespace {

using test::window_from;
using test::window_upwards;

TEST(EdgeWindow, FromAPointMeasuresFromIt) {
  const EdgeWindow w = window_from(1, -3, 0, 8, 2);
  EXPECT_DOUBLE_EQ(w.value(1), 5);
  EXPECT_DOUBLE_EQ(w.value(5), 7);  // 3, 4, 5
  EXPECT_DOUBLE_EQ(w.lowest(), 5);
  double arc = 0;
  EXPECT_DOUBLE_EQ(w.value_beyond(1, 4, arc), 9);
  EXPECT_DOUBLE_EQ(w.value_beyond(9, 3, arc), 12);  // 6, 8, 10
}

TEST(EdgeWindow, FromASegmentMeasuresAtRightAnglesToIt) {
  EdgeWindow w = window_upwards(2, 6, 1);
  w.arc = 10;
  EXPECT_DOUBLE_EQ(w.value(2), 1);
  EXPECT_DOUBLE_EQ(w.value(5), 1);
  EXPECT_DOUBLE_EQ(w.arc_at(5), 15);
  double arc = 0;
  EXPECT_DOUBLE_EQ(w.value_beyond(5, 3, arc), 4);
  EXPECT_DOUBLE_EQ(arc, 15);
}

TEST(EdgeWindow, WaysThatMissItBendAtItsEnd) {
  const EdgeWindow w = window_upwards(2, 6, 1);
  double arc = 0, at = 0;
  EXPECT_FALSE(w.bends_towards(4, 3, at));
  ASSERT_TRUE(w.bends_towards(10, 3, at));
  EXPECT_EQ(at, 6);
  EXPECT_DOUBLE_EQ(w.value_beyond(10, 3, arc), 1 + 5);  // 3, 4, 5
}

TEST(EdgeWindow, TurnedIsTheSameFromTheOtherEnd) {
  for (const EdgeWindow& w : {window_from(1, -3, 0, 5, 2), window_upwards(2, 6, 1)}) {
    const EdgeWindow turned = w.turned(8);
    EXPECT_EQ(turned.begin, 8 - w.end);
    EXPECT_EQ(turned.end, 8 - w.begin);
    for (const double x : {0.0, 3.0, 8.0}) {
      EXPECT_DOUBLE_EQ(turned.value(8 - x), w.value(x));
      EXPECT_DOUBLE_EQ(turned.arc_at(8 - x), w.arc_at(x));
    }
  }
}

TEST(EdgeWindow, IsCutAtItsEndsAndNotInside) {
  const auto cut = [](double from, double to) {
    EdgeWindow w = window_from(0, -1, 2, 6);
    w.cut(from, to, 0.25, 0.5);
    return w;
  };
  EXPECT_EQ(cut(1, 3).begin, 2.75);  // with the overlap
  EXPECT_EQ(cut(5, 7).end, 5.25);
  EXPECT_EQ(cut(3, 5).begin, 2);
  EXPECT_EQ(cut(3, 5).end, 6);
  EXPECT_TRUE(cut(2.5, 5.5).is_empty());  // the rest would be too narrow
}

TEST(WhereBelow, FindsOneCrossingOrTwo) {
  // The place 2 is equally far from (0, -1) and (4, -1).
  const Stretches half =
      where_below(window_from(0, -1, 0, 4), window_from(4, -1, 0, 4), 0, 4, 0, 1e-9);
  ASSERT_EQ(half.count, 1);
  EXPECT_EQ(half.at[0][0], 0);
  EXPECT_NEAR(half.at[0][1], 2, 2e-9);
  // The square roots of r^2 + 4 and r^2 + 1/4 differ by 1 where r^2 = 105 / 64.
  const EdgeWindow far = window_from(2, -2, 0, 4), near = window_from(2, -0.5, 0, 4, 1);
  const double r = std::sqrt(105.0) / 8;
  const Stretches inside = where_below(near, far, 0, 4, 0, 1e-9);
  ASSERT_EQ(inside.count, 1);
  EXPECT_NEAR(inside.at[0][0], 2 - r, 2e-9);
  EXPECT_NEAR(inside.at[0][1], 2 + r, 2e-9);
  const Stretches outside = where_below(far, near, 0, 4, 0, 1e-9);
  ASSERT_EQ(outside.count, 2);
  EXPECT_NEAR(outside.at[0][1], 2 - r, 2e-9);
  EXPECT_NEAR(outside.at[1][0], 2 + r, 2e-9);
}

}  // namespace
}  // namespace talweg

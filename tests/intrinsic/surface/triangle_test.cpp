#include "talweg/intrinsic/surface/triangle.hpp"

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

using namespace test;

double angle_sum(double a, double b, double c) {
  return angle_between(a, b, c) + angle_between(b, c, a) + angle_between(c, a, b);
}

TEST(Triangle, KnownAngles) {
  constexpr double kEps = 4e-16;
  EXPECT_NEAR(angle_between(1, 1, 1), kPi / 3, kEps);
  EXPECT_NEAR(angle_between(3, 4, 5), kPi / 2, kEps);
  EXPECT_NEAR(angle_between(4, 3, 5), kPi / 2, kEps);
  EXPECT_NEAR(angle_between(1, 2, std::sqrt(3)), kPi / 3, 1e-15);
  EXPECT_DOUBLE_EQ(angle_between(3, 5, 4), angle_between(5, 3, 4));
}

TEST(Triangle, NeedlesKeepRelativeAccuracy) {
  // Isosceles with legs 1 and base c: the angle between the legs is 2 asin(c / 2).
  // (Below 1e-150 of the legs the products underflow.)
  for (double c = 1; c > 1e-150; c /= 7) {
    const double exact = 2 * std::asin(c / 2);
    EXPECT_NEAR(angle_between(1, 1, c) / exact, 1.0, 4e-16) << c;
    EXPECT_NEAR(angle_between(1, c, 1), std::acos(c / 2), 1e-15) << c;
  }
}

TEST(Triangle, NearlyFlatTriangles) {
  // Legs 1, base 2 - h: sin(half the angle) = 1 - h/2, so pi minus the angle is 4 asin(√h / 2).
  for (const double wanted : {1e-3, 1e-9, 1e-13}) {
    const double base = 2 - wanted;
    const double h = 2 - base;  // the rounded value of h
    EXPECT_NEAR(kPi - angle_between(1, 1, base), 4 * std::asin(std::sqrt(h) / 2), 1e-15);
  }
}

TEST(Triangle, AnglesSumToPi) {
  Random random(1);
  for (int k = 0; k < 10000; ++k) {
    // Any three positive weights make a triangle; spread wide they make needles.
    const double x = std::pow(10, random.uniform(-9, 9)), y = std::pow(10, random.uniform(-9, 9));
    const double z = std::pow(10, random.uniform(-9, 9));
    EXPECT_NEAR(angle_sum(x + y, y + z, z + x), kPi, 1e-7);
    if (std::max({x, y, z}) < 1e6 * std::min({x, y, z})) {
      EXPECT_NEAR(angle_sum(x + y, y + z, z + x), kPi, 1e-9);
    }
  }
}

TEST(Triangle, DegenerateTrianglesAreFlatAndSumToPi) {
  EXPECT_EQ(angle_between(1, 2, 3), kPi);
  EXPECT_EQ(angle_between(1, 3, 2), 0);
  EXPECT_EQ(angle_between(2, 3, 1), 0);
  for (const auto& [a, b, c] : {std::array{1.0, 2.0, 3.0},
                                {1, 1, 2},
                                {0, 1, 1},
                                {5, 0, 5},
                                {1, 1, 3},
                                {1, 9, 2},
                                {0, 1, 2},
                                {7, 0, 1e-9},
                                {0, 0, 0}}) {
    EXPECT_NEAR(angle_sum(a, b, c), kPi, 1e-15) << a << " " << b << " " << c;
    EXPECT_NEAR(angle_sum(c, a, b), kPi, 1e-15);
    EXPECT_NEAR(angle_sum(b, a, c), kPi, 1e-15);
  }
  EXPECT_EQ(angle_between(1, 0, 1), kPi / 2);
}

TEST(Triangle, Area) {
  EXPECT_DOUBLE_EQ(triangle_area(3, 4, 5), 6);
  EXPECT_DOUBLE_EQ(triangle_area(5, 3, 4), 6);
  EXPECT_DOUBLE_EQ(triangle_area(13, 14, 15), 84);
  EXPECT_EQ(triangle_area(1, 2, 3), 0);
  EXPECT_EQ(triangle_area(1, 1, 5), 0);
  EXPECT_EQ(triangle_area(0, 0, 0), 0);
  // Isosceles needle: c sqrt(1 - c²/4) / 2.
  for (double c = 1; c > 1e-100; c /= 10) {
    EXPECT_NEAR(triangle_area(1, 1, c) / (c / 2 * std::sqrt(1 - c * c / 4)), 1, 1e-15);
    EXPECT_EQ(triangle_area(1, c, 1), triangle_area(c, 1, 1));
  }
}

TEST(Triangle, ApexHasTheGivenDistances) {
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const double base = random.uniform(0.1, 2), x = random.uniform(-3, 3), y = random.uniform(0, 3);
    const PlanePoint p = apex(base, std::hypot(x, y), std::hypot(x - base, y));
    EXPECT_NEAR(p.x, x, 1e-13);
    // y is the root of a difference of squares of size ~10.
    EXPECT_NEAR(p.y * p.y, y * y, 1e-13);
  }
  EXPECT_EQ(apex(0, 2, 2).y, 2);
  EXPECT_EQ(apex(3, 1, 2).y, 0);
  EXPECT_DOUBLE_EQ(apex(3, 1, 2).x, 1);
}

}  // namespace
}  // namespace talweg

#include "talweg/core/lifting/potential.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

TEST(Potential, IsThePapersByDefault) {
  const double length = 3.5, tau = 0.7;
  const Potential phi({}, tau, length);
  for (const double d : {0.0, 1e-9, 0.2, 3.5, 100.0}) {
    const double expected = length * std::pow(10 * tau * d / length, 2);
    EXPECT_NEAR(phi(d), expected, 1e-15 * expected);
  }
}

TEST(Potential, TauZeroIsFlat) {
  const Potential phi({}, 0, 2);
  EXPECT_EQ(phi(0), 0);
  EXPECT_EQ(phi(17), 0);
}

TEST(Potential, ScalesWithTheMesh) {
  for (const auto shape :
       {PotentialOptions::Shape::kPower, PotentialOptions::Shape::kExponential}) {
    PotentialOptions options;
    options.shape = shape;
    const Potential small(options, 1.3, 2), large(options, 1.3, 2e6);
    EXPECT_NEAR(large(0.4e6), 1e6 * small(0.4), 1e-9 * large(0.4e6));
  }
}

TEST(Potential, HasTheAlternativeShapes) {
  PotentialOptions cubic;
  cubic.exponent = 3;
  EXPECT_NEAR(Potential(cubic, 1, 4)(0.5), 4 * std::pow(10 * 0.5 / 4, 3), 1e-14);
  PotentialOptions exponential;
  exponential.shape = PotentialOptions::Shape::kExponential;
  EXPECT_NEAR(Potential(exponential, 1, 4)(0.5), 4 * (std::exp(10 * 0.5 / 4) - 1), 1e-13);
  EXPECT_EQ(Potential(exponential, 1, 4)(0), 0);
}

TEST(Potential, StaysFinite) {
  PotentialOptions exponential;
  exponential.shape = PotentialOptions::Shape::kExponential;
  EXPECT_TRUE(std::isfinite(Potential(exponential, 1e6, 1e-3)(1e6)));
  EXPECT_TRUE(std::isfinite(Potential({}, 1e200, 1)(1e200)));
  EXPECT_EQ(Potential({}, 1, 1)(std::numeric_limits<double>::infinity()), 0);
}

TEST(Potential, RefusesValuesOutOfRange) {
  EXPECT_THROW(Potential({}, -1, 1), Error);
  EXPECT_THROW(Potential({}, std::nan(""), 1), Error);
  EXPECT_THROW(Potential({}, 1, 0), Error);
  PotentialOptions options;
  options.exponent = 0.5;
  EXPECT_THROW(Potential(options, 1, 1), Error);
  options = {};
  options.gain = 0;
  EXPECT_THROW(Potential(options, 1, 1), Error);
}

TEST(LiftedLengths, KeepTheTriangleInequalityInAnyDimension) {
  // Lifted sides are distances in R^k, also for a nearly flat triangle with arbitrary heights.
  const double ab = 1, bc = 1, ca = 1.9999999;
  const double a[] = {0, 3, -7}, b[] = {1e3, -2, 0.5}, c[] = {-40, 0, 12};
  const double x = lifted_length(ab, a, b), y = lifted_length(bc, b, c),
               z = lifted_length(ca, c, a);
  EXPECT_LE(x, y + z);
  EXPECT_LE(y, z + x);
  EXPECT_LE(z, x + y);
  EXPECT_DOUBLE_EQ(lifted_length(3, 1.0, 5.0), 5);
}

}  // namespace
}  // namespace talweg

#include "talweg/core/space/message_numbers.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace talweg {
namespace {

TEST(PositionText, HasAThousandthOfAnEdge) {
  EXPECT_EQ(position_text({12.34567, -0.00049, 7}, 1), "(12.346, 0, 7)");
  EXPECT_EQ(position_text({1.0 / 3, 2.0 / 3, 0.5}, 0.02), "(0.33333, 0.66667, 0.5)");
  EXPECT_EQ(position_text({-0.0, 0, 1e-12}, 1), "(0, 0, 0)");
}

TEST(PositionText, TellsVerticesApartFarFromTheOrigin) {
  EXPECT_EQ(position_text({500000.25, 4200083.126, 812.5}, 1), "(500000.25, 4200083.126, 812.5)");
  EXPECT_EQ(position_text({4200083.126, 4200084.126, 0}, 50), "(4200083.13, 4200084.13, 0)");
  EXPECT_EQ(position_text({4200083.126, 0, 0}, 1e5), "(4200083, 0, 0)");  // no digit is lost
}

TEST(PositionText, HoldsInTinyAndHugeUnits) {
  EXPECT_EQ(position_text({1.25e-30, -3e-31, 0}, 1e-30), "(1.25e-30, -3e-31, 0)");
  EXPECT_EQ(position_text({1e60, 2.5e60, 0}, 1e58), "(1e+60, 2.5e+60, 0)");
}

TEST(PositionText, HasAllDigitsWhereNoEdgeIsKnown) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double edge : {0.0, std::nan(""), infinite}) {
    EXPECT_EQ(position_text({0.1, 4200083.126, 0}, edge), "(0.1, 4200083.126, 0)") << edge;
  }
  EXPECT_EQ(position_text({infinite, 1, 2}, 1), "(inf, 1, 2)");
}

TEST(CountText, GroupsThousands) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(94294), "94,294");
  EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(LengthText, KeepsAllWholeUnitsWithoutAnExponent) {
  EXPECT_EQ(length_text(4821040.25, 6), "4,821,040");
  EXPECT_EQ(length_text(999999.7, 6), "1,000,000");
  EXPECT_EQ(length_text(123456.7, 6), "123,457");
  EXPECT_EQ(length_text(99999.96, 6), "100,000");
  EXPECT_EQ(length_text(99999.94, 6), "99999.9");
  EXPECT_EQ(length_text(1234.5, 4), "1,234");
  EXPECT_EQ(length_text(0.96, 1), "1");
  EXPECT_EQ(length_text(123.45678, 6), "123.457");
  EXPECT_EQ(length_text(12345.6, 4), "12,346");
  EXPECT_EQ(length_text(0.000123456, 4), "0.0001235");
  EXPECT_EQ(length_text(0, 6), "0");
  EXPECT_EQ(length_text(2.5e60, 6), "2.5e+60");
  EXPECT_EQ(length_text(std::numeric_limits<double>::infinity(), 6), "inf");
}

TEST(MeshUnitsText, HasASingular) {
  EXPECT_EQ(mesh_units_text(1), "1 mesh unit");
  EXPECT_EQ(mesh_units_text(2.0791), "2.08 mesh units");
  EXPECT_EQ(mesh_units_text(4821.4), "4,821 mesh units");
  EXPECT_EQ(mesh_units_text(1.00001, 6), "1.00001 mesh units");
}

TEST(BoundsText, LeavesLowerBoundsOfRoundingSizeOut) {
  EXPECT_EQ(bounds_text(2, 3), "at most 3 and at least 2");
  EXPECT_EQ(bounds_text(1.2e-9, 3.5), "at most 3.5");
  EXPECT_EQ(bounds_text(0, 3.5), "at most 3.5");
}

TEST(BoundsText, KeepsAllWholeUnitsWithoutAnExponent) {
  EXPECT_EQ(bounds_text(2e6, 4821040.25), "at most 4,821,040 and at least 2,000,000");
}

TEST(BoundsText, HasNoInfiniteUpperBound) {
  EXPECT_EQ(bounds_text(2, std::numeric_limits<double>::infinity()), "at least 2");
}

}  // namespace
}  // namespace talweg

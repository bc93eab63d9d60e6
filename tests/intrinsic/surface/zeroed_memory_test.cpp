// Arrays that begin with zeros.
#include "talweg/intrinsic/surface/zeroed_memory.hpp"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

namespace talweg {
namespace {

TEST(ZeroedMemory, BeginsAsZerosAndKeepsValuesWhenItGrows) {
  ZeroedVector<double> values(100000);
  EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](double v) { return v == 0; }));
  values[7] = 3;
  values.resize(300000);
  EXPECT_EQ(values[7], 3);
  EXPECT_EQ(std::count(values.begin(), values.end(), 0.0), 299999);
  const ZeroedVector<double> copy = values;
  EXPECT_EQ(copy, values);
}

TEST(ZeroedMemory, AppendedElementsHaveTheirValue) {
  ZeroedVector<std::uint32_t> values(10, 5);
  values.resize(2);
  values.resize(6, 0);
  values.push_back(9);
  EXPECT_EQ(values, (ZeroedVector<std::uint32_t>{5, 5, 0, 0, 0, 0, 9}));
}

}  // namespace
}  // namespace talweg

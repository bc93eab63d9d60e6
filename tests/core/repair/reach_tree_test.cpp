#include "talweg/core/repair/reach_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "talweg/core/space/point_distance.hpp"

namespace talweg {
namespace {

TEST(ReachTree, AgreesWithComparisonsOfAllPairs) {
  std::size_t apart = 0, joined = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    // From nearly all apart to nearly all in one group, and with reaches that differ widely.
    const std::size_t n = 2 + random() % 300;
    const double longest = std::pow(10, -2 * part(random)), widely = 4 * part(random);
    std::vector<Point> points;
    std::vector<double> reach;
    for (std::size_t i = 0; i < n; ++i) {
      points.emplace_back(part(random), part(random), seed % 2 == 0 ? part(random) : 0);
      reach.push_back(longest * std::pow(10, -widely * part(random)));
    }
    std::vector<std::uint32_t> vertices(n);
    std::iota(vertices.begin(), vertices.end(), 0U);
    UnionFind expected(n), found(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t k = 0; k < i; ++k) {
        const double bound = std::min(reach[i], reach[k]);
        if (point_distance(points[i], points[k]) <= bound) expected.join(i, k);
      }
    }
    std::shuffle(vertices.begin(), vertices.end(), random);
    ReachTree(points, reach, vertices, found).join();
    for (std::uint32_t i = 0; i < n; ++i) {
      ASSERT_EQ(found.find(i), expected.find(i)) << i;
      (found.find(i) == i ? apart : joined) += 1;
    }
  }
  EXPECT_GT(apart, 2000U);
  EXPECT_GT(joined, 2000U);
}

}  // namespace
}  // namespace talweg

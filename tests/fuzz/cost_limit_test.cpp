// An input that runs too many blocks for its size is aborted. The blocks of this file are counted,
// too.
#include "cost_limit.hpp"

#include <gtest/gtest.h>

#include "growth/counted_blocks.hpp"

namespace talweg::fuzz {
namespace {

/// Runs at least this number of blocks.
void spend(std::uint64_t blocks) {
  for (std::uint64_t k = 0; k < blocks; ++k) {
    [[maybe_unused]] volatile std::uint64_t kept = k;  // keeps the loop from being removed
  }
}

TEST(CostLimitDeathTest, EndsAnInputAboveFiftyMediansOfItsSize) {
  const double median = 10;
  const std::size_t size = 36;  // plus an allowance of 64: 50'000 blocks
  EXPECT_DEATH(
      {
        const CostLimit limit(median, size);
        spend(50'000);
      },
      "50 times the usual cost");
  const CostLimit limit(median, size);
  spend(10'000);
  EXPECT_GE(limit.blocks(), 10'000U);
}

TEST(CostLimit, IsOverWithItsInput) {
  { const CostLimit limit(1, 0); }
  spend(10'000);
  const CostLimit none(0, 0);
  spend(10'000);
}

TEST(CountedBlocks, CallAsSoonAsThatManyHaveRun) {
  static std::uint64_t at = 0;
  const std::uint64_t before = test::blocks_run();
  test::after_blocks(500, [] { at = test::blocks_run(); });
  spend(5'000);
  test::after_blocks(0, nullptr);
  EXPECT_GE(at - before, 500U);
  EXPECT_LE(at - before, 510U);  // a few blocks of the call itself
}

}  // namespace
}  // namespace talweg::fuzz

#include "talweg/heat/supernodes.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "talweg/heat/fill_reducing_order.hpp"
#include "talweg/heat/symmetric_matrix.hpp"
#include "test_matrices.hpp"

namespace talweg {
namespace {

/// The structure of the factor by elimination as in the textbook: column by column, every pair of
/// later neighbours becomes adjacent.
std::vector<std::set<std::int32_t>> eliminated(const SymmetricMatrix& matrix,
                                               const std::vector<std::int32_t>& old_of_new) {
  const PermutedEntries entries = permuted_entries(matrix, old_of_new);
  std::vector<std::set<std::int32_t>> column(matrix.size());
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = entries.start[j]; k < entries.start[j + 1]; ++k) {
      column[j].insert(entries.entries[k].row);
    }
  }
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    if (column[j].size() < 2) continue;
    const std::int32_t parent = *std::next(column[j].begin());
    column[parent].insert(std::next(column[j].begin()), column[j].end());
  }
  return column;
}

class SupernodesOf : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Grids, SupernodesOf, testing::Values(1, 2, 3, 7, 20, 45));

TEST_P(SupernodesOf, OrderIsAPermutationAndCountsAreThoseOfElimination) {
  const SymmetricMatrix matrix = test::grid_matrix(GetParam(), 4.5);
  const FillReducingOrder order = fill_reducing_order(matrix);
  std::vector<std::int32_t> sorted = order.old_of_new;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    ASSERT_EQ(sorted[k], static_cast<std::int32_t>(k));
  }
  const auto columns = eliminated(matrix, order.old_of_new);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    EXPECT_EQ(static_cast<std::size_t>(order.column_count[j]), columns[j].size()) << j;
  }
}

TEST_P(SupernodesOf, BlocksHoldTheStructureOfElimination) {
  const SymmetricMatrix matrix = test::grid_matrix(GetParam(), 4.5);
  FillReducingOrder order = fill_reducing_order(matrix);
  const auto columns = eliminated(matrix, order.old_of_new);
  const PermutedEntries entries = permuted_entries(matrix, order.old_of_new);
  const Supernodes s = supernodes_of(entries, order.old_of_new, order.column_count);
  ASSERT_EQ(s.size(), matrix.size());
  ASSERT_EQ(s.first.front(), 0);
  ASSERT_EQ(static_cast<std::size_t>(s.first.back()), s.size());
  for (std::size_t k = 0; k < s.count(); ++k) {
    ASSERT_GT(s.width(k), 0u);
    const auto below = s.rows_below(k);
    EXPECT_TRUE(std::is_sorted(below.begin(), below.end()));
    EXPECT_EQ(s.block_start[k + 1] - s.block_start[k], s.width(k) * s.height(k));
    std::set<std::int32_t> needed;
    for (std::int32_t j = s.first[k]; j < s.first[k + 1]; ++j) {
      for (const std::int32_t row : columns[j]) {
        if (row >= s.first[k + 1]) needed.insert(row);
      }
    }
    // Exactly the rows that some column of the block needs.
    EXPECT_EQ(std::set<std::int32_t>(below.begin(), below.end()), needed) << k;
    if (below.empty()) {
      EXPECT_EQ(s.parent[k], -1);
    } else {
      ASSERT_GT(s.parent[k], static_cast<std::int32_t>(k));
      EXPECT_GE(below.front(), s.first[s.parent[k]]);
      EXPECT_LT(below.front(), s.first[s.parent[k] + 1]);
    }
  }
}

}  // namespace
}  // namespace talweg

#include "talweg/heat/simplicial_factor.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/intrinsic/error.hpp"
#include "test_matrices.hpp"

namespace talweg {
namespace {

std::vector<double> waves(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t j = 0; j < n; ++j) x[j] = std::sin(static_cast<double>(j));
  return x;
}

/// In a build with CHOLMOD the other factor is from CHOLMOD.
TEST(SimplicialFactor, SolvesAsTheFactorOfTheBuild) {
  for (const SymmetricMatrix& matrix :
       {test::grid_matrix(1, 4), test::grid_matrix(60, 4), test::expander_matrix(500)}) {
    const std::vector<double> b = multiply(matrix, waves(matrix.size()));
    const std::vector<double> own = SimplicialFactor(SimplicialOrder(matrix), matrix).solve(b);
    const std::vector<double> other = CholeskyFactor(SymbolicFactor(matrix), matrix).solve(b);
    // Condition numbers of 3000 at most, times the rounding of b.
    for (std::size_t j = 0; j < b.size(); ++j) EXPECT_NEAR(own[j], other[j], 1e-11) << j;
  }
}

TEST(SimplicialFactor, TheOrderHasEveryPlaceOnceAndFillsLittle) {
  const SymmetricMatrix matrix = test::grid_matrix(100, 4);
  const SimplicialOrder order(matrix);
  std::vector<char> taken(matrix.size(), 0);
  for (const std::int32_t place : order.places()) taken.at(static_cast<std::size_t>(place)) += 1;
  EXPECT_EQ(taken, std::vector<char>(matrix.size(), 1));
  // In row order the factor would have a full band of 100 below the diagonal; n log n is the
  // minimum.
  EXPECT_LT(order.factor_entries(), 40 * matrix.size());
  EXPECT_GE(order.factor_entries(), matrix.row.size());
}

/// Elimination of a tree from its leaves has no fill; elimination of an arrow from its tip fills
/// everything.
TEST(SimplicialFactor, EntriesAreCounted) {
  SymmetricMatrix arrow{
      {0, 5, 6, 7, 8, 9}, {0, 1, 2, 3, 4, 1, 2, 3, 4}, {9, 1, 1, 1, 1, 9, 9, 9, 9}};
  EXPECT_EQ(SimplicialOrder(arrow).factor_entries(), 9u);
  SymmetricMatrix full{{0, 3, 5, 6}, {0, 1, 2, 1, 2, 2}, {4, 1, 1, 4, 1, 4}};
  EXPECT_EQ(SimplicialOrder(full).factor_entries(), 6u);
}

TEST(SimplicialFactor, NamesTheColumnThatIsNotPositive) {
  SymmetricMatrix matrix = test::grid_matrix(9, 4);
  matrix.diagonal(40) = -5;
  try {
    const SimplicialFactor factor(SimplicialOrder(matrix), matrix);
    FAIL() << "an indefinite matrix was factored";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNumerical);
    EXPECT_NE(std::string(error.what()).find("column 40)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace talweg

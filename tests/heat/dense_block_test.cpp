#include "talweg/heat/dense_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace talweg {
namespace {

/// height × width by columns; entries in [-1, 1], a diagonal that makes the whole definite.
std::vector<double> random_block(std::size_t height, std::size_t width, double diagonal) {
  std::mt19937 random(static_cast<unsigned>(100 * height + width));
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> block(height * width);
  for (double& value : block) value = number(random);
  for (std::size_t j = 0; j < std::min(height, width); ++j) block[j * height + j] += diagonal;
  return block;
}

const std::size_t kHeights[] = {1, 2, 3, 4, 5, 7, 8, 9, 16, 31, 70, 150};

TEST(DenseBlock, OuterProductIsSubtractedOnAndBelowTheDiagonal) {
  for (const std::size_t rows : kHeights) {
    for (const std::size_t inner : {1, 3, 64, 65, 130}) {
      const std::size_t columns = (rows + 1) / 2, stride = rows + 3;
      const std::vector<double> a = random_block(stride, inner, 0);
      const std::vector<double> before = random_block(stride, columns, 0);
      std::vector<double> c = before;
      DenseScratch scratch;
      subtract_outer(c.data(), stride, rows, columns, a.data(), stride, inner, scratch);
      for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t i = j; i < stride; ++i) {
          double expected = before[j * stride + i];
          for (std::size_t t = 0; i < rows && t < inner; ++t) {
            expected -= a[t * stride + i] * a[t * stride + j];
          }
          // A sum of `inner` products of size 1 at most, in another order.
          EXPECT_NEAR(c[j * stride + i], expected, 1e-15 * static_cast<double>(inner * inner + 1));
        }
      }
    }
  }
}

TEST(DenseBlock, FactorTimesItsTransposeIsTheMatrix) {
  for (const std::size_t height : kHeights) {
    for (const std::size_t width : {std::size_t{1}, (height + 1) / 2, height}) {
      const auto size = static_cast<double>(height);
      const std::vector<double> matrix = random_block(height, width, 2 * size);
      std::vector<double> factor = matrix;
      DenseScratch scratch;
      ASSERT_EQ(factor_block(factor.data(), height, width, scratch), width);
      for (std::size_t j = 0; j < width; ++j) {
        for (std::size_t i = j; i < height; ++i) {
          double product = 0;
          for (std::size_t k = 0; k <= j; ++k) {
            product += factor[k * height + i] * factor[k * height + j];
          }
          EXPECT_NEAR(product, matrix[j * height + i], 1e-15 * size * size + 1e-14);
        }
      }
    }
  }
}

TEST(DenseBlock, TheFirstPivotThatIsNotPositiveIsNamed) {
  for (const std::size_t bad : {0, 1, 8, 11}) {
    std::vector<double> matrix = random_block(12, 12, 24);
    matrix[bad * 12 + bad] = -1;
    DenseScratch scratch;
    EXPECT_EQ(factor_block(matrix.data(), 12, 12, scratch), bad);
  }
}

TEST(DenseBlock, SolvesUndoTheProductWithTheTriangle) {
  for (const std::size_t height : kHeights) {
    for (const std::size_t width : {std::size_t{1}, (height + 1) / 2, height}) {
      const auto size = static_cast<double>(height);
      const std::vector<double> block = random_block(height, width, 2 * size);
      const auto at = [&](std::size_t i, std::size_t j) { return block[j * height + i]; };
      std::vector<double> x(height);
      for (std::size_t i = 0; i < height; ++i) x[i] = std::sin(static_cast<double>(i + 1));

      // [L 0; B I] x forward, and (L, B)ᵀ x backward.
      std::vector<double> lower = x, upper = x;
      for (std::size_t i = 0; i < height; ++i) {
        if (i < width) lower[i] = 0;
        for (std::size_t j = 0; j < std::min(i + 1, width); ++j) lower[i] += at(i, j) * x[j];
      }
      for (std::size_t j = 0; j < width; ++j) {
        upper[j] = 0;
        for (std::size_t i = j; i < height; ++i) upper[j] += at(i, j) * x[i];
      }
      std::vector<double> spacious = block;  // 1e300 behind it must not show
      spacious.resize(block.size() + kSpare, 1e300);
      lower.resize(height + kSpare, 0.0);
      upper.resize(height + kSpare, 0.0);
      solve_forward(spacious.data(), height, width, lower.data());
      solve_backward(spacious.data(), height, width, upper.data());
      for (std::size_t i = 0; i < height; ++i) {
        EXPECT_NEAR(lower[i], x[i], 1e-14 * size) << height << " " << width;
        EXPECT_NEAR(upper[i], x[i], 1e-14 * size) << height << " " << width;
      }
    }
  }
}

}  // namespace
}  // namespace talweg

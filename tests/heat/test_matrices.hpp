// Sparse matrices for the tests of the factor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg::test {

/// The five-point stencil on side × side points, with `diagonal` on the diagonal: definite from 4
/// on.
inline SymmetricMatrix grid_matrix(std::size_t side, double diagonal) {
  SymmetricMatrix matrix;
  matrix.column_start.push_back(0);
  const auto add = [&](std::size_t row, double value) {
    matrix.row.push_back(static_cast<std::int32_t>(row));
    matrix.value.push_back(value);
  };
  for (std::size_t j = 0; j < side * side; ++j) {
    add(j, diagonal);
    if ((j + 1) % side != 0) add(j + 1, -1);
    if (j + side < side * side) add(j + side, -1);
    matrix.column_start.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

/// An expander: each of n points is joined with three random points, so every elimination order
/// fills the factor. Positive definite.
inline SymmetricMatrix expander_matrix(std::int32_t n) {
  std::vector<std::vector<std::int32_t>> below(static_cast<std::size_t>(n));
  std::uint64_t random = 1;
  for (std::int32_t j = 0; j < 3 * n; ++j) {
    random = random * 6364136223846793005U + 1442695040888963407U;
    const auto other = static_cast<std::int32_t>((random >> 33U) % static_cast<std::uint64_t>(n));
    if (other != j % n) below[std::min(j % n, other)].push_back(std::max(j % n, other));
  }
  SymmetricMatrix matrix{{0}, {}, {}};
  for (std::int32_t j = 0; j < n; ++j) {
    std::vector<std::int32_t>& rows = below[static_cast<std::size_t>(j)];
    rows.push_back(j);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (const std::int32_t row : rows) {
      matrix.row.push_back(row);
      matrix.value.push_back(row == j ? n : -1);
    }
    matrix.column_start.push_back(static_cast<std::int32_t>(matrix.row.size()));
  }
  return matrix;
}

}  // namespace talweg::test

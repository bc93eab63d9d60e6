// Test matrices are sparse, and are for the tests of the factor.
#pragma once

#include <cstddef>
#include <cstdint>

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

}  // namespace talweg::test

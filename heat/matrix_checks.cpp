#include "talweg/heat/matrix_checks.hpp"

#include <cmath>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

void check_pattern(const SymmetricMatrix& matrix) {
  const std::size_t n = matrix.size();
  bool good = n > 0 && matrix.column_start[0] == 0 &&
              static_cast<std::size_t>(matrix.column_start[n]) == matrix.row.size();
  for (std::size_t j = 0; good && j < n; ++j) {
    const std::int32_t begin = matrix.column_start[j], end = matrix.column_start[j + 1];
    good = begin < end && static_cast<std::size_t>(matrix.row[begin]) == j;
    for (std::int32_t k = begin + 1; good && k < end; ++k) {
      good = matrix.row[k] > matrix.row[k - 1] && static_cast<std::size_t>(matrix.row[k]) < n;
    }
    if (!good) {
      throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: column " + std::to_string(j) +
                                             " is not a sorted lower triangle with diagonal.");
    }
  }
  if (!good) throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: it is empty.");
}

void check_values(const SymmetricMatrix& matrix) {
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      if (std::isfinite(matrix.value[k])) continue;
      throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix has an entry in column " +
                                             std::to_string(j) + " that is not finite.");
    }
  }
}

}  // namespace talweg

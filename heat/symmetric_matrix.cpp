#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

void replace_by_identity(SymmetricMatrix& matrix, const std::vector<char>& fixed) {
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      if (fixed[j] != 0 || fixed[matrix.row[k]] != 0) matrix.value[k] = 0;
    }
    if (fixed[j] != 0) matrix.diagonal(j) = 1;
  }
}

std::vector<double> multiply(const SymmetricMatrix& matrix, const std::vector<double>& x) {
  std::vector<double> y(matrix.size(), 0.0);
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    y[j] += matrix.diagonal(j) * x[j];
    for (std::int32_t k = matrix.column_start[j] + 1; k < matrix.column_start[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(matrix.row[k]);
      y[i] += matrix.value[k] * x[j];
      y[j] += matrix.value[k] * x[i];
    }
  }
  return y;
}

}  // namespace talweg

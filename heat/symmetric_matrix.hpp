// A symmetric matrix is sparse, and is stored in plain arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace talweg {

/// The lower triangle of an n × n symmetric matrix by compressed columns: column j owns the entries
/// [column_start[j], column_start[j + 1]); its rows are >= j and increase strictly. Every column
/// stores its diagonal, which therefore comes first.
struct SymmetricMatrix {
  std::vector<std::int32_t> column_start;  ///< n + 1 numbers
  std::vector<std::int32_t> row;           ///< of each entry
  std::vector<double> value;               ///< of each entry

  [[nodiscard]] std::size_t size() const {
    return column_start.empty() ? 0 : column_start.size() - 1;
  }
  [[nodiscard]] double& diagonal(std::size_t j) { return value[column_start[j]]; }
  [[nodiscard]] double diagonal(std::size_t j) const { return value[column_start[j]]; }
};

/// Rows and columns with fixed[j] != 0 become rows and columns of the identity; the pattern stays.
/// `fixed` has one entry per column.
void replace_by_identity(SymmetricMatrix& matrix, const std::vector<char>& fixed);

/// The product matrix · x; x has one entry per column. O(entries).
std::vector<double> multiply(const SymmetricMatrix& matrix, const std::vector<double>& x);

}  // namespace talweg

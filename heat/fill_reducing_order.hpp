// A fill-reducing order tells in which order to eliminate the unknowns of a sparse matrix.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// Position k of the factor belongs to row and column `old_of_new[k]` of the matrix; the order is a
/// postorder of the elimination tree.
struct FillReducingOrder {
  std::vector<std::int32_t> old_of_new;
  /// Entries of each column of the factor, its diagonal included, by new position.
  std::vector<std::int32_t> column_count;
};

/// Nested dissection (METIS) where CHOLMOD has it, else minimum degree (AMD). METIS draws from the
/// process's random numbers, which it seeds itself; calls therefore run one at a time, and the
/// same pattern gives the same order unless other code calls rand() in the meantime.
/// `pattern` must be as SymmetricMatrix demands, and not empty.
/// Throws Error(kOutOfMemory) when memory runs out.
FillReducingOrder fill_reducing_order(const SymmetricMatrix& pattern);

}  // namespace talweg

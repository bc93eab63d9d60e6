// Supernodes are columns of equal structure of a sparse Cholesky factor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// A factor whose columns are grouped into supernodes: consecutive columns that are stored as one
/// dense block. Rows and columns are counted in the order of elimination; an `old` index is one of
/// the matrix as it was given.
struct Supernodes {
  std::vector<std::int32_t> old_of_new;  ///< by position in the order of elimination
  std::vector<std::int32_t> first;       ///< first column of each supernode; one more at the end
  std::vector<std::int32_t> parent;      ///< the supernode of its first row below; -1 at a root
  std::vector<std::size_t> row_start;    ///< of each supernode in `rows`; one more at the end
  std::vector<std::int32_t> rows;        ///< below the supernode's own columns, increasing
  std::vector<std::size_t> block_start;  ///< of each block among the factor's values; one more

  [[nodiscard]] std::size_t size() const { return old_of_new.size(); }
  [[nodiscard]] std::size_t count() const { return parent.size(); }
  [[nodiscard]] std::size_t width(std::size_t s) const { return first[s + 1] - first[s]; }
  [[nodiscard]] std::span<const std::int32_t> rows_below(std::size_t s) const {
    return std::span(rows).subspan(row_start[s], row_start[s + 1] - row_start[s]);
  }
  /// Rows of the block of s: its own columns and the rows below. Blocks are stored by columns of
  /// this height.
  [[nodiscard]] std::size_t height(std::size_t s) const {
    return width(s) + row_start[s + 1] - row_start[s];
  }
};

/// Where the entries of a matrix go: column j of the permuted lower triangle owns the entries
/// [start[j], start[j + 1]).
struct PermutedEntries {
  struct Entry {
    std::int32_t row;    ///< in the order of elimination, >= the column
    std::int32_t entry;  ///< number of its value in the matrix as given
  };
  std::vector<std::int32_t> start;
  std::vector<Entry> entries;
};

PermutedEntries permuted_entries(const SymmetricMatrix& pattern,
                                 std::span<const std::int32_t> old_of_new);

/// The supernodes of the factor of a pattern whose permuted entries these are. `old_of_new` is a
/// postorder of the elimination tree and `column_count` the factor's entries in each column.
///
/// Small supernodes are merged with their parents, which adds zeros to the blocks, where the
/// blocks' regularity is worth them (Ashcraft & Grimes 1989, "The influence of relaxed supernode
/// partitions on the multifrontal method"). O(entries of the matrix + rows).
Supernodes supernodes_of(const PermutedEntries& matrix, std::vector<std::int32_t> old_of_new,
                         std::span<const std::int32_t> column_count);

}  // namespace talweg

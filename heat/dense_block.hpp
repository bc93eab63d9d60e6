// A dense block is a part of a sparse Cholesky factor that is worked on as a dense matrix.
#pragma once

#include <cstddef>
#include <vector>

namespace talweg {

/// Room that the routines below reuse from call to call.
using DenseScratch = std::vector<double>;

/// Matrices are stored by columns, `stride` numbers apart. All sums run in a fixed order, so the
/// results do not depend on the width of the machine's vectors.

/// C -= A Aᵀ, where A has `rows` rows and `inner` columns; only the first `columns` columns of C,
/// and of those what is on or below the diagonal. Entries above the diagonal may change, within
/// the first `columns` rows.
void subtract_outer(double* c, std::size_t c_stride, std::size_t rows, std::size_t columns,
                    const double* a, std::size_t a_stride, std::size_t inner,
                    DenseScratch& scratch);

/// Replaces the first `width` columns of a symmetric matrix, `height` rows on or below the
/// diagonal, by those of its Cholesky factor. Returns `width`, or the column whose pivot is not
/// positive; the block is then half done.
std::size_t factor_block(double* block, std::size_t height, std::size_t width,
                         DenseScratch& scratch);

/// The solves go down the columns four rows at a time, without a shorter last step, so they need
/// kSpare numbers more behind the block (finite) and behind x (zeros).
inline constexpr std::size_t kSpare = 3;

/// x := L⁻¹ x for the first `width` entries of x, L the lower triangle of the block's first rows;
/// and x -= B x for the others, B the rows below. What is behind x is lost.
void solve_forward(const double* block, std::size_t height, std::size_t width, double* x);

/// The first `width` entries of x := L⁻ᵀ (x - Bᵀ y), y the entries of x below.
void solve_backward(const double* block, std::size_t height, std::size_t width, double* x);

}  // namespace talweg

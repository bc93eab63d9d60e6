// Sparse Cholesky factorization: order and analyse once, factor, solve many.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// The fill-reducing ordering and the shape of the factor of every matrix with one pattern.
/// Immutable and cheap to copy (shared); any number of threads may factor from it.
///
/// Nested dissection (METIS) where CHOLMOD has it, else minimum degree (AMD). METIS draws from the
/// process's random numbers, which it seeds itself; analyses therefore run one at a time, and the
/// same pattern gives the same ordering unless other code calls rand() in the meantime.
class SymbolicFactor {
 public:
  /// Only the pattern is looked at. Throws Error(kOutOfMemory) when memory runs out or the factor
  /// would have 2^31 entries or more, Error(kNumerical) when the pattern is not as SymmetricMatrix
  /// demands.
  explicit SymbolicFactor(const SymmetricMatrix& pattern);

  [[nodiscard]] std::size_t size() const;
  /// Entries of the triangular factor.
  [[nodiscard]] std::size_t factor_entries() const;

 private:
  friend class CholeskyFactor;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// The factor L of P A Pᵀ = L Lᵀ, A symmetric positive definite; simplicial, so the same bytes on
/// every run. Holds 12 bytes per factor entry.
class CholeskyFactor {
 public:
  /// `matrix` must have the pattern that was analysed. Throws Error(kNumerical) when an entry is
  /// not finite or the matrix is not positive definite (the message names the column),
  /// Error(kOutOfMemory) when memory runs out.
  CholeskyFactor(const SymbolicFactor& symbolic, const SymmetricMatrix& matrix);
  ~CholeskyFactor();
  CholeskyFactor(CholeskyFactor&&) noexcept;
  CholeskyFactor& operator=(CholeskyFactor&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  /// The x with A x = b; b has size() entries. O(factor entries). Any number of threads may solve
  /// with one factor at the same time: each call has its own workspace.
  /// Throws Error(kBadUsage) for a b of another size, Error(kOutOfMemory) when memory runs out.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talweg

// A Cholesky factor of a sparse matrix is ordered and analysed once, then solves many times.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// The fill-reducing ordering and the shape of the factor of every matrix with one pattern.
/// Immutable and cheap to copy (shared); any number of threads may factor from it.
/// The same pattern gives the same ordering, with the reserve of fill_reducing_order().
class SymbolicFactor {
 public:
  /// Only the pattern is looked at. Throws Error(kOutOfMemory) when memory runs out,
  /// Error(kNumerical) when the pattern is not as SymmetricMatrix demands.
  explicit SymbolicFactor(const SymmetricMatrix& pattern);

  [[nodiscard]] std::size_t size() const;
  /// Numbers stored for the factor, 8 bytes each: its entries and the zeros between them that make
  /// its blocks regular.
  [[nodiscard]] std::size_t factor_entries() const;

 private:
  friend class CholeskyFactor;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// The factor L of P A Pᵀ = L Lᵀ, A symmetric positive definite, in dense blocks of columns with
/// equal structure. One thread, every sum in a fixed order: the same bytes on every run.
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
  /// The x with A x = b; b has size() entries. O(factor entries); where b is 0 nearly everywhere,
  /// half of that, since blocks that no entry reaches are skipped. Any number of threads may solve
  /// with one factor at the same time: each call has its own workspace.
  /// Throws Error(kBadUsage) for a b of another size, Error(kOutOfMemory) when memory runs out.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talweg

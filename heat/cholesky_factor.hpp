// A Cholesky factor of a sparse matrix is ordered and analysed once, then solves many times.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// How CHOLMOD stores a factor. Supernodes (dense blocks of columns with equal structure) are
/// worked on by the BLAS; that module of CHOLMOD is under the GPL. Without it (TALWEG_SUPERNODAL
/// off, or a CHOLMOD that was built without it) every factor is simplicial, column by column, which
/// takes about four times as long to factor. Eigen's factor, used without CHOLMOD (TALWEG_CHOLMOD
/// off), is simplicial, too.
enum class FactorKind { kSupernodal, kSimplicial };

/// The fill-reducing ordering and the shape of the factor of every matrix with one pattern.
/// Immutable and cheap to copy (shared); any number of threads may factor from it.
///
/// The order is nested dissection (METIS) where CHOLMOD has it, else minimum degree (AMD). METIS
/// draws from the process's random numbers, which it seeds itself; analyses therefore run one at a
/// time, and the same pattern gives the same order unless other code calls rand() meanwhile.
class SymbolicFactor {
 public:
  /// Only the pattern is looked at. Throws Error(kOutOfMemory) when memory runs out or the factor
  /// would have 2^31 entries or more, Error(kNumerical) when the pattern is not as SymmetricMatrix
  /// demands.
  explicit SymbolicFactor(const SymmetricMatrix& pattern,
                          FactorKind kind = FactorKind::kSupernodal);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] FactorKind kind() const;
  /// Numbers stored for the factor, 8 bytes each: its entries and, in supernodes, zeros that make
  /// the blocks regular.
  [[nodiscard]] std::size_t factor_entries() const;

 private:
  friend class CholeskyFactor;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// CHOLMOD's factor L of P A Pᵀ = L Lᵀ, A symmetric positive definite (Chen, Davis, Hager &
/// Rajamanickam 2008, "Algorithm 887: CHOLMOD"), or Eigen's. Computed on one thread: the same bytes
/// on every run with the same libraries on the same machine.
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

/// The libraries that factor and solve, with their versions, in one line.
std::string factor_libraries();

}  // namespace talweg

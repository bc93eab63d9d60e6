// A simplicial factor is Eigen's Cholesky factor, for builds without CHOLMOD.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// The order of elimination (approximate minimum degree) and the size of the factor of every matrix
/// with one pattern. Immutable.
class SimplicialOrder {
 public:
  /// Only the pattern is looked at. Throws Error as SymbolicFactor does.
  explicit SimplicialOrder(const SymmetricMatrix& pattern);

  [[nodiscard]] std::size_t size() const { return place_.size(); }
  /// Entries of the factor, 12 bytes each.
  [[nodiscard]] std::size_t factor_entries() const { return entries_; }
  /// The place of each column in the order.
  [[nodiscard]] const std::vector<std::int32_t>& places() const { return place_; }

 private:
  std::vector<std::int32_t> place_;
  std::size_t entries_ = 0;
};

/// Eigen's SimplicialLLT in the order of a SimplicialOrder. One thread: the same bytes on every
/// run.
class SimplicialFactor {
 public:
  /// Throws Error as CholeskyFactor does.
  SimplicialFactor(const SimplicialOrder& order, const SymmetricMatrix& matrix);
  ~SimplicialFactor();
  SimplicialFactor(SimplicialFactor&&) noexcept;
  SimplicialFactor& operator=(SimplicialFactor&&) noexcept;

  /// The x with A x = b; b has size() entries. Any number of threads may solve at the same time.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talweg

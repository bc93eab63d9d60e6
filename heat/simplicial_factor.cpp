#include "talweg/heat/simplicial_factor.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include "talweg/heat/matrix_checks.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>;

[[noreturn]] void out_of_memory(const char* what) {
  throw Error(ErrorCode::kOutOfMemory, std::string(what) + " failed: out of memory.");
}

/// The upper triangle of the matrix with columns and rows permuted to their places.
Matrix ordered(const SymmetricMatrix& matrix, const std::vector<std::int32_t>& place) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  Matrix result(n, n);
  std::vector<std::int32_t> count(matrix.size(), 0);
  const auto each = [&](auto&& entry) {
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
        const std::int32_t p = place[j], q = place[static_cast<std::size_t>(matrix.row[k])];
        entry(std::max(p, q), std::min(p, q), matrix.value[k]);
      }
    }
  };
  each([&](std::int32_t column, std::int32_t, double) { ++count[column]; });
  result.reserve(count);
  each([&](std::int32_t column, std::int32_t row, double value) {
    result.insert(row, column) = value;
  });
  result.makeCompressed();
  return result;
}

template <template <class, int, class> class Kind>
using Factorization = Kind<Matrix, Eigen::Upper, Eigen::NaturalOrdering<std::int32_t>>;

/// The column where L Lᵀ fails: the first with a pivot in L D Lᵀ that is not positive.
std::int32_t not_positive(const Matrix& upper) {
  Factorization<Eigen::SimplicialLDLT> factor(upper);
  const Eigen::VectorXd d = factor.vectorD();
  std::int32_t k = 0;
  while (k + 1 < d.size() && d[k] > 0) ++k;
  return k;
}

/// The number of entries of the factor. The entries of a row lie on the paths up the elimination
/// tree from the row's entries in the matrix: Liu 1990, "The role of elimination trees in sparse
/// factorization". O(entries of the factor).
std::size_t entries_of_factor(const Matrix& upper) {
  const auto n = static_cast<std::size_t>(upper.cols());
  std::vector<std::int32_t> parent(n, -1), seen(n, -1);
  std::size_t entries = n;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(n); ++k) {
    seen[k] = k;
    for (Matrix::InnerIterator it(upper, k); it; ++it) {
      for (auto i = static_cast<std::int32_t>(it.row()); i < k && seen[i] != k; i = parent[i]) {
        if (parent[i] < 0) parent[i] = k;
        seen[i] = k;
        ++entries;
      }
    }
  }
  return entries;
}

}  // namespace

SimplicialOrder::SimplicialOrder(const SymmetricMatrix& pattern) try {
  check_pattern(pattern);
  SymmetricMatrix ones{pattern.column_start, pattern.row,
                       std::vector<double>(pattern.row.size(), 1.0)};
  place_.resize(ones.size());
  for (std::size_t j = 0; j < place_.size(); ++j) place_[j] = static_cast<std::int32_t>(j);
  {
    const Matrix upper = ordered(ones, place_);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> order;
    Eigen::AMDOrdering<std::int32_t>()(upper.selfadjointView<Eigen::Upper>(), order);
    for (std::size_t k = 0; k < place_.size(); ++k) {
      place_[static_cast<std::size_t>(order.indices()[static_cast<Eigen::Index>(k)])] =
          static_cast<std::int32_t>(k);
    }
  }
  entries_ = entries_of_factor(ordered(ones, place_));
  if (entries_ > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw Error(ErrorCode::kOutOfMemory,
                "Ordering the matrix failed: the factor has too many entries for 32-bit indices.");
  }
} catch (const std::bad_alloc&) {
  out_of_memory("Ordering the matrix");
}

struct SimplicialFactor::Impl {
  std::vector<std::int32_t> place;
  Factorization<Eigen::SimplicialLLT> factor;
};

SimplicialFactor::SimplicialFactor(const SimplicialOrder& order, const SymmetricMatrix& matrix) {
  if (matrix.size() != order.size() || matrix.value.size() != matrix.row.size()) {
    throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix is not the analysed one.");
  }
  check_values(matrix);
  try {
    impl_ = std::make_unique<Impl>();
    impl_->place = order.places();
    const Matrix upper = ordered(matrix, impl_->place);
    impl_->factor.compute(upper);
    if (impl_->factor.info() == Eigen::Success) return;
    const std::int32_t stopped = not_positive(upper);
    const auto column = std::find(impl_->place.begin(), impl_->place.end(), stopped);
    throw Error(ErrorCode::kNumerical,
                "Factoring failed: the matrix is not positive definite (column " +
                    std::to_string(column - impl_->place.begin()) + ").");
  } catch (const std::bad_alloc&) {
    out_of_memory("Factoring");
  }
}

SimplicialFactor::~SimplicialFactor() = default;
SimplicialFactor::SimplicialFactor(SimplicialFactor&&) noexcept = default;
SimplicialFactor& SimplicialFactor::operator=(SimplicialFactor&&) noexcept = default;

std::vector<double> SimplicialFactor::solve(const std::vector<double>& b) const try {
  const std::vector<std::int32_t>& place = impl_->place;
  Eigen::VectorXd x(static_cast<Eigen::Index>(b.size()));
  for (std::size_t j = 0; j < b.size(); ++j) x[place[j]] = b[j];
  impl_->factor.matrixL().solveInPlace(x);
  impl_->factor.matrixU().solveInPlace(x);
  std::vector<double> result(b.size());
  for (std::size_t j = 0; j < b.size(); ++j) result[j] = x[place[j]];
  return result;
} catch (const std::bad_alloc&) {
  out_of_memory("Solving");
}

}  // namespace talweg

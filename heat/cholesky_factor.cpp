#include "talweg/heat/cholesky_factor.hpp"

#include <cmath>
#include <limits>
#include <mutex>
#include <string>

#include <cholmod.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// CHOLMOD's settings and workspace, silent. One per call, so that calls share nothing.
class Workspace {
 public:
  Workspace() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    common_.final_ll = 1;
    common_.grow0 = common_.grow1 = 0;  // columns never grow: no spare room in the factor
    common_.grow2 = 0;
  }
  ~Workspace() { cholmod_finish(&common_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

 private:
  cholmod_common common_{};
};

struct FactorDeleter {
  void operator()(cholmod_factor* factor) const {
    Workspace work;
    cholmod_free_factor(&factor, work.get());
  }
};
using FactorPtr = std::unique_ptr<cholmod_factor, FactorDeleter>;

struct DenseDeleter {
  void operator()(cholmod_dense* dense) const {
    Workspace work;
    cholmod_free_dense(&dense, work.get());
  }
};
using DensePtr = std::unique_ptr<cholmod_dense, DenseDeleter>;

std::string status_in_words(int status) {
  switch (status) {
    case CHOLMOD_NOT_INSTALLED:
      return "a part of CHOLMOD is not installed";
    case CHOLMOD_OUT_OF_MEMORY:
      return "out of memory";
    case CHOLMOD_TOO_LARGE:
      return "the matrix is too large for 32-bit indices";
    case CHOLMOD_INVALID:
      return "CHOLMOD rejected its input";
    case CHOLMOD_NOT_POSDEF:
      return "the matrix is not positive definite";
    case CHOLMOD_DSMALL:
      return "the matrix is singular to working precision";
    default:
      return "CHOLMOD status " + std::to_string(status);
  }
}

[[noreturn]] void fail(const std::string& task, int status) {
  const bool memory = status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE;
  throw Error(memory ? ErrorCode::kOutOfMemory : ErrorCode::kNumerical,
              task + " failed: " + status_in_words(status) + ".");
}

/// A view of our arrays; CHOLMOD reads but never writes them.
cholmod_sparse view(const SymmetricMatrix& matrix, bool with_values) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = matrix.size();
  sparse.nzmax = matrix.row.size();
  sparse.p = const_cast<std::int32_t*>(matrix.column_start.data());
  sparse.i = const_cast<std::int32_t*>(matrix.row.data());
  sparse.x = with_values ? const_cast<double*>(matrix.value.data()) : nullptr;
  sparse.stype = -1;
  sparse.itype = CHOLMOD_INT;
  sparse.xtype = with_values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = 1;
  sparse.packed = 1;
  return sparse;
}

void check_pattern(const SymmetricMatrix& matrix) {
  const std::size_t n = matrix.size();
  bool good = n > 0 && matrix.column_start[0] == 0 &&
              static_cast<std::size_t>(matrix.column_start[n]) == matrix.row.size();
  for (std::size_t j = 0; good && j < n; ++j) {
    const std::int32_t begin = matrix.column_start[j], end = matrix.column_start[j + 1];
    good = begin < end && static_cast<std::size_t>(matrix.row[begin]) == j;
    for (std::int32_t k = begin + 1; good && k < end; ++k) {
      good = matrix.row[k] > matrix.row[k - 1] && static_cast<std::size_t>(matrix.row[k]) < n;
    }
    if (!good) {
      throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: column " + std::to_string(j) +
                                             " is not a sorted lower triangle with diagonal.");
    }
  }
  if (!good) throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: it is empty.");
}

FactorPtr analyze(cholmod_sparse& matrix, int ordering, Workspace& work) {
  static std::mutex one_at_a_time;  // METIS uses rand()
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  work->nmethods = 1;
  work->method[0].ordering = ordering;
  return FactorPtr(cholmod_analyze(&matrix, work.get()));
}

}  // namespace

struct SymbolicFactor::Impl {
  FactorPtr factor;
  std::size_t entries = 0;
};

SymbolicFactor::SymbolicFactor(const SymmetricMatrix& pattern) {
  check_pattern(pattern);
  Workspace work;
  cholmod_sparse matrix = view(pattern, false);
  auto impl = std::make_shared<Impl>();
  impl->factor = analyze(matrix, CHOLMOD_METIS, work);
  if (!impl->factor && work->status != CHOLMOD_OUT_OF_MEMORY) {
    impl->factor = analyze(matrix, CHOLMOD_AMD, work);
  }
  if (!impl->factor) fail("Ordering the matrix", work->status);
  if (!(work->lnz < static_cast<double>(std::numeric_limits<std::int32_t>::max()))) {
    fail("Ordering the matrix", CHOLMOD_TOO_LARGE);
  }
  impl->entries = static_cast<std::size_t>(work->lnz);
  impl_ = std::move(impl);
}

std::size_t SymbolicFactor::size() const { return impl_->factor->n; }
std::size_t SymbolicFactor::factor_entries() const { return impl_->entries; }

struct CholeskyFactor::Impl {
  FactorPtr factor;
};

CholeskyFactor::CholeskyFactor(const SymbolicFactor& symbolic, const SymmetricMatrix& matrix)
    : impl_(std::make_unique<Impl>()) {
  if (matrix.size() != symbolic.size() || matrix.value.size() != matrix.row.size()) {
    throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix is not the analysed one.");
  }
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      if (std::isfinite(matrix.value[k])) continue;
      throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix has an entry in column " +
                                             std::to_string(j) + " that is not finite.");
    }
  }
  Workspace work;
  impl_->factor.reset(cholmod_copy_factor(symbolic.impl_->factor.get(), work.get()));
  if (!impl_->factor) fail("Factoring", work->status);
  cholmod_sparse sparse = view(matrix, true);
  cholmod_factorize(&sparse, impl_->factor.get(), work.get());
  const cholmod_factor& factor = *impl_->factor;
  if (work->status == CHOLMOD_NOT_POSDEF || factor.minor < factor.n) {
    const auto* order = static_cast<const std::int32_t*>(factor.Perm);
    throw Error(ErrorCode::kNumerical, "Factoring failed: " + status_in_words(CHOLMOD_NOT_POSDEF) +
                                           " (column " + std::to_string(order[factor.minor]) +
                                           ").");
  }
  if (work->status != CHOLMOD_OK) fail("Factoring", work->status);
}

CholeskyFactor::~CholeskyFactor() = default;
CholeskyFactor::CholeskyFactor(CholeskyFactor&&) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&&) noexcept = default;

std::size_t CholeskyFactor::size() const { return impl_->factor->n; }

std::vector<double> CholeskyFactor::solve(const std::vector<double>& b) const {
  if (b.size() != size()) {
    throw Error(ErrorCode::kBadUsage, "The right-hand side has " + std::to_string(b.size()) +
                                          " entries instead of " + std::to_string(size()) + ".");
  }
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = b.size();
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  Workspace work;
  const DensePtr x(cholmod_solve(CHOLMOD_A, impl_->factor.get(), &right, work.get()));
  if (!x) fail("Solving", work->status);
  const auto* values = static_cast<const double*>(x->x);
  return {values, values + b.size()};
}

}  // namespace talweg

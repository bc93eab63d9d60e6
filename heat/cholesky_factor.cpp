#include "talweg/heat/cholesky_factor.hpp"

#include <cstdint>
#include <mutex>
#include <new>
#include <string>
#include <utility>

#include <cholmod.h>

#include "talweg/heat/blas.hpp"
#include "talweg/heat/matrix_checks.hpp"
#include "talweg/heat/process_lock.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// CHOLMOD's settings and workspace, without printing. Each call has its own, so calls share
/// nothing.
class Workspace {
 public:
  Workspace() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    common_.nmethods = 1;
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    common_.final_ll = 1;  // L Lᵀ in any case: L D Lᵀ would accept an indefinite matrix
  }
  ~Workspace() { cholmod_finish(&common_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  cholmod_common* get() { return &common_; }
  cholmod_common* operator->() { return &common_; }

  [[nodiscard]] bool full() const {
    return common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE;
  }
  /// Throws an Error if the last call of CHOLMOD failed; `what` names the step.
  void check(const char* what) const {
    if (common_.status >= CHOLMOD_OK) return;
    const std::string failed = std::string(what) + " failed: ";
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) {
      throw Error(ErrorCode::kOutOfMemory, failed + "out of memory.");
    }
    if (common_.status == CHOLMOD_TOO_LARGE) {
      throw Error(ErrorCode::kOutOfMemory,
                  failed + "the factor has too many entries for 32-bit indices.");
    }
    throw Error(ErrorCode::kNumerical,
                failed + "CHOLMOD status " + std::to_string(common_.status) + ".");
  }

 private:
  cholmod_common common_{};
};

struct Free {
  void operator()(cholmod_factor* factor) const {
    Workspace work;
    cholmod_free_factor(&factor, work.get());
  }
  void operator()(cholmod_dense* dense) const {
    Workspace work;
    cholmod_free_dense(&dense, work.get());
  }
};

using DensePtr = std::unique_ptr<cholmod_dense, Free>;

/// CHOLMOD's view of a matrix or a right-hand side, to which CHOLMOD never writes.
cholmod_sparse view(const SymmetricMatrix& matrix, int values) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = matrix.size();
  sparse.nzmax = matrix.row.size();
  sparse.p = const_cast<std::int32_t*>(matrix.column_start.data());
  sparse.i = const_cast<std::int32_t*>(matrix.row.data());
  if (values == CHOLMOD_REAL) sparse.x = const_cast<double*>(matrix.value.data());
  sparse.stype = -1;  // the lower triangle
  sparse.itype = CHOLMOD_INT;
  sparse.xtype = values;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = 1;
  sparse.packed = 1;
  return sparse;
}

cholmod_dense view(const std::vector<double>& vector) {
  cholmod_dense dense{};
  dense.nrow = dense.d = dense.nzmax = vector.size();
  dense.ncol = 1;
  dense.x = const_cast<double*>(vector.data());
  dense.xtype = CHOLMOD_REAL;
  dense.dtype = CHOLMOD_DOUBLE;
  return dense;
}

/// Runs `task` on one BLAS thread and returns its result. Throws Error(kOutOfMemory) when memory
/// runs out.
template <class Task>
auto on_one_thread(BlasWork work, const char* what, Task&& task) {
  try {
    const OneBlasThread one_thread(work);
    return task();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, std::string(what) + " failed: out of memory.");
  }
}

int cholmod_kind(FactorKind kind) {
#ifdef TALWEG_NO_SUPERNODAL
  (void)kind;
  return CHOLMOD_SIMPLICIAL;
#else
  return kind == FactorKind::kSupernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
#endif
}

cholmod_factor* analyze(cholmod_sparse& matrix, int ordering, Workspace& work) {
  static std::mutex one_at_a_time;  // METIS uses rand()
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  const ProcessLock process_lock(ProcessLock::Resource::kRandomNumbers);
  work->method[0].ordering = ordering;
  return cholmod_analyze(&matrix, work.get());
}

}  // namespace

struct SymbolicFactor::Impl {
  explicit Impl(cholmod_factor* analysed) : factor(analysed, Free()) {}
  std::shared_ptr<cholmod_factor> factor;  // without values
  std::size_t entries = 0;
};

SymbolicFactor::SymbolicFactor(const SymmetricMatrix& pattern, FactorKind kind) {
  check_pattern(pattern);
  Workspace work;
  work->supernodal = cholmod_kind(kind);
  cholmod_sparse matrix = view(pattern, CHOLMOD_PATTERN);
  auto* factor = analyze(matrix, CHOLMOD_METIS, work);
  if (factor == nullptr && !work.full()) factor = analyze(matrix, CHOLMOD_AMD, work);
  auto impl = std::make_shared<Impl>(factor);
  work.check("Ordering the matrix");
  impl->entries = factor->is_super != 0 ? factor->xsize : static_cast<std::size_t>(work->lnz);
  impl_ = std::move(impl);
}

std::size_t SymbolicFactor::size() const { return impl_->factor->n; }
FactorKind SymbolicFactor::kind() const {
  return impl_->factor->is_super != 0 ? FactorKind::kSupernodal : FactorKind::kSimplicial;
}
std::size_t SymbolicFactor::factor_entries() const { return impl_->entries; }

struct CholeskyFactor::Impl {
  explicit Impl(cholmod_factor* copied) : factor(copied, Free()) {}
  std::shared_ptr<cholmod_factor> factor;
};

CholeskyFactor::CholeskyFactor(const SymbolicFactor& symbolic, const SymmetricMatrix& matrix) {
  if (matrix.size() != symbolic.size() || matrix.value.size() != matrix.row.size()) {
    throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix is not the analysed one.");
  }
  check_values(matrix);
  Workspace work;
  impl_ = std::make_unique<Impl>(cholmod_copy_factor(symbolic.impl_->factor.get(), work.get()));
  work.check("Factoring");
  cholmod_sparse values = view(matrix, CHOLMOD_REAL);
  cholmod_factor* factor = impl_->factor.get();
  on_one_thread(BlasWork::kFactor, "Factoring",
                [&] { return cholmod_factorize(&values, factor, work.get()); });
  work.check("Factoring");
  if (factor->minor < factor->n) {
    const auto* order = static_cast<const std::int32_t*>(factor->Perm);
    throw Error(ErrorCode::kNumerical,
                "Factoring failed: the matrix is not positive definite (column " +
                    std::to_string(order[factor->minor]) + ").");
  }
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
  Workspace work;
  cholmod_dense right = view(b);
  return on_one_thread(BlasWork::kSolve, "Solving", [&] {
    // Bset stays null: it would convert the factor, which other threads use, into a simplicial one.
    cholmod_dense *solution = nullptr, *permuted = nullptr, *gathered = nullptr;
    cholmod_solve2(CHOLMOD_A, impl_->factor.get(), &right, nullptr, &solution, nullptr, &permuted,
                   &gathered, work.get());
    const DensePtr owned[] = {DensePtr(solution), DensePtr(permuted), DensePtr(gathered)};
    work.check("Solving");
    const auto* x = static_cast<const double*>(solution->x);
    return std::vector<double>(x, x + b.size());
  });
}

std::string factor_libraries() {
  int version[3] = {};
  cholmod_version(version);
  const SymbolicFactor symbolic({{0, 1}, {0}, {1.0}});
  const bool supernodal = symbolic.kind() == FactorKind::kSupernodal;
  return "CHOLMOD " + std::to_string(version[0]) + "." + std::to_string(version[1]) + "." +
         std::to_string(version[2]) + ", " +
         (supernodal ? "supernodal, with " + blas_library() : "simplicial");
}

}  // namespace talweg

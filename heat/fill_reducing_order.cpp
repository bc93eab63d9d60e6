#include "talweg/heat/fill_reducing_order.hpp"

#include <cstddef>
#include <memory>
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
    common_.supernodal = CHOLMOD_SIMPLICIAL;  // the other analysis is GPL
    common_.nmethods = 1;
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

/// A view of our arrays; CHOLMOD reads but never writes them.
cholmod_sparse view(const SymmetricMatrix& matrix) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = matrix.size();
  sparse.nzmax = matrix.row.size();
  sparse.p = const_cast<std::int32_t*>(matrix.column_start.data());
  sparse.i = const_cast<std::int32_t*>(matrix.row.data());
  sparse.stype = -1;
  sparse.itype = CHOLMOD_INT;
  sparse.xtype = CHOLMOD_PATTERN;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = 1;
  sparse.packed = 1;
  return sparse;
}

FactorPtr analyze(cholmod_sparse& matrix, int ordering, Workspace& work) {
  static std::mutex one_at_a_time;  // METIS uses rand()
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  work->method[0].ordering = ordering;
  return FactorPtr(cholmod_analyze(&matrix, work.get()));
}

}  // namespace

FillReducingOrder fill_reducing_order(const SymmetricMatrix& pattern) {
  Workspace work;
  cholmod_sparse matrix = view(pattern);
  FactorPtr factor = analyze(matrix, CHOLMOD_METIS, work);
  if (!factor && work->status != CHOLMOD_OUT_OF_MEMORY) factor = analyze(matrix, CHOLMOD_AMD, work);
  if (!factor) {
    const bool memory = work->status == CHOLMOD_OUT_OF_MEMORY || work->status == CHOLMOD_TOO_LARGE;
    throw Error(memory ? ErrorCode::kOutOfMemory : ErrorCode::kNumerical,
                "Ordering the matrix failed: " +
                    (memory ? std::string("out of memory.")
                            : "CHOLMOD status " + std::to_string(work->status) + "."));
  }
  const auto* order = static_cast<const std::int32_t*>(factor->Perm);
  const auto* count = static_cast<const std::int32_t*>(factor->ColCount);
  return {{order, order + factor->n}, {count, count + factor->n}};
}

}  // namespace talweg

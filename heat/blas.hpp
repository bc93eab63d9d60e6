// The BLAS is the library of dense matrix operations that CHOLMOD uses.
#pragma once

#include <mutex>
#include <string>

namespace talweg {

/// Name, version and file of the BLAS of this process, as far as they are known.
std::string blas_library();

enum class BlasWork { kFactor, kSolve };

/// While a OneBlasThread lives, OpenBLAS and OpenMP use one thread for calls from the thread that
/// constructed it. Sums therefore do not depend on the number of cores, and the caller decides how
/// many threads run. The last OneBlasThread restores the thread counts of the process, unless other
/// code has changed them meanwhile. Calls of the same OpenBLAS from other threads are slower during
/// this time, but otherwise unaffected. Other libraries (MKL, BLIS) keep their threads. A thread
/// must not construct a second OneBlasThread while it has one.
class OneBlasThread {
 public:
  /// Waits for the end of another OneBlasThread where OpenBLAS has no memory for one more, and for
  /// other factorizations where OpenBLAS was built without threads. Throws std::bad_alloc when
  /// there is no memory for the first one.
  explicit OneBlasThread(BlasWork work);
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  std::unique_lock<std::mutex> alone_;
  int openmp_threads_ = 1, openmp_levels_ = 0;  // of this thread, to be restored
};

}  // namespace talweg

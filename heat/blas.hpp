// The BLAS is the library of dense matrices that CHOLMOD computes with.
#pragma once

#include <mutex>
#include <string>

namespace talweg {

/// Name, version and file of the BLAS of this process, as far as it tells them.
std::string blas_library();

enum class BlasWork { kFactor, kSolve };

/// While one lives, OpenBLAS and OpenMP use one thread for calls from the thread that made it: so
/// sums do not depend on the number of cores, and threads are the caller's to choose. The last one
/// puts the process's numbers back, unless somebody else has changed them meanwhile. Other threads'
/// calls of the same OpenBLAS are slower as long, and nothing else. Other libraries (MKL, BLIS)
/// keep their threads. A thread must not make a second one while it has one.
class OneBlasThread {
 public:
  /// Waits for others to go where OpenBLAS has no memory for one more, and for other factors where
  /// it was built without threads. Throws std::bad_alloc when it has no memory at all.
  explicit OneBlasThread(BlasWork work);
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  std::unique_lock<std::mutex> alone_;
  int openmp_threads_ = 1, openmp_levels_ = 0;  // of this thread; what is put back
};

}  // namespace talweg

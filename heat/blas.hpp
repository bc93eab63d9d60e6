// The BLAS is the library of dense matrices that CHOLMOD computes with.
#pragma once

#include <string>

namespace talweg {

/// Name, version and file of the BLAS of this process, as far as it tells them.
std::string blas_library();

/// While one lives, OpenBLAS and OpenMP use one thread for calls from the thread that made it: so
/// sums do not depend on the number of cores, and threads are the caller's to choose. The last one
/// puts the process's numbers back, unless somebody else has changed them meanwhile. Other threads'
/// calls of the same OpenBLAS are slower as long, and nothing else. Other libraries (MKL, BLIS)
/// keep their threads. A thread must not make a second one while it has one.
class OneBlasThread {
 public:
  /// Waits for others to go where OpenBLAS was built without threads, which only one thread may
  /// call at a time, or has no memory for one more. Throws std::bad_alloc when it has none at all.
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int openmp_threads_ = 1, openmp_levels_ = 0;  // of this thread; what is put back
};

}  // namespace talweg

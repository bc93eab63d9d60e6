#include "talweg/heat/blas.hpp"

#include <filesystem>
#include <mutex>
#include <system_error>

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace talweg {
namespace {

#if __has_include(<dlfcn.h>)

/// A function of a library that may be there or not; talweg links none of them itself.
template <class Function>
Function* find(const char* name, void* library = RTLD_DEFAULT) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// The file of the BLAS, and its name if it tells one.
std::string name_of_blas() {
  Dl_info blas{};
  auto* multiply = find<void()>("dgemm_");
  if (multiply == nullptr || dladdr(reinterpret_cast<void*>(multiply), &blas) == 0) return "";
  std::error_code none;
  std::string name = std::filesystem::canonical(blas.dli_fname, none).string();
  // LAPACK may come from another OpenBLAS than dgemm, so the library itself is asked.
  void* library = dlopen(blas.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  if (library == nullptr) return name;
  if (auto* config = find<char*()>("openblas_get_config", library)) {
    const std::string text = config();  // "OpenBLAS 0.3.21 NO_LAPACKE DYNAMIC_ARCH ..."
    name.insert(0, text.substr(0, text.find(' ', text.find(' ') + 1)) + ", ");
  }
  dlclose(library);
  return name;
}

#else

template <class Function>
Function* find(const char*) {
  return nullptr;
}
std::string name_of_blas() { return ""; }

#endif

/// OpenBLAS has one number of threads for the whole process, unless it is built on OpenMP.
struct OpenBlas {
  int (*threads)() = find<int()>("openblas_get_num_threads");
  void (*set_threads)(int) = find<void(int)>("openblas_set_num_threads");
  int (*parallel)() = find<int()>("openblas_get_parallel");

  [[nodiscard]] bool has_own_threads() const {
    constexpr int kOwnThreads = 1;
    return threads != nullptr && set_threads != nullptr && parallel != nullptr &&
           parallel() == kOwnThreads;
  }
};

/// OpenMP has its numbers for each thread of the process. CHOLMOD's loops ask for four threads by
/// themselves, so no parallel level is allowed; OpenBLAS splits its work by the number of threads.
struct OpenMp {
  int (*threads)() = find<int()>("omp_get_max_threads");
  void (*set_threads)(int) = find<void(int)>("omp_set_num_threads");
  int (*levels)() = find<int()>("omp_get_max_active_levels");
  void (*set_levels)(int) = find<void(int)>("omp_set_max_active_levels");

  [[nodiscard]] bool found() const {
    return threads != nullptr && set_threads != nullptr && levels != nullptr &&
           set_levels != nullptr;
  }
};

const OpenMp& open_mp() {
  static const OpenMp found;
  return found;
}

/// How many OneBlasThreads live, and OpenBLAS' number before the first of them.
class OpenBlasThreads {
 public:
  void hold() {
    if (!counted_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (holders_++ > 0) return;
    before_ = blas_.threads();
    if (before_ != 1) blas_.set_threads(1);
  }
  void release() {
    if (!counted_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--holders_ > 0) return;
    if (before_ != 1 && blas_.threads() == 1) blas_.set_threads(before_);
  }

 private:
  OpenBlas blas_;
  bool counted_ = blas_.has_own_threads();
  std::mutex mutex_;
  int holders_ = 0, before_ = 1;
};

OpenBlasThreads& open_blas_threads() {
  static OpenBlasThreads threads;
  return threads;
}

}  // namespace

std::string blas_library() {
  const std::string name = name_of_blas();
  return name.empty() ? "a BLAS that does not tell its name" : name;
}

OneBlasThread::OneBlasThread() {
  open_blas_threads().hold();
  const OpenMp& omp = open_mp();
  if (!omp.found()) return;
  openmp_threads_ = omp.threads();
  openmp_levels_ = omp.levels();
  if (openmp_threads_ != 1) omp.set_threads(1);
  if (openmp_levels_ != 0) omp.set_levels(0);
}

OneBlasThread::~OneBlasThread() {
  const OpenMp& omp = open_mp();
  if (openmp_threads_ != 1) omp.set_threads(openmp_threads_);
  if (openmp_levels_ != 0) omp.set_levels(openmp_levels_);
  open_blas_threads().release();
}

}  // namespace talweg

#include "talweg/heat/blas.hpp"

#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include "talweg/heat/process_lock.hpp"

namespace talweg {
namespace {

#if __has_include(<dlfcn.h>)

/// Finds a function of a library that the process may or may not have; Talweg itself does not link
/// the library.
template <class Function>
Function* find(const char* name, void* library = RTLD_DEFAULT) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// The file of the BLAS, with name and version if the BLAS is OpenBLAS.
std::string name_of_blas() {
  Dl_info blas{};
  auto* multiply = find<void()>("dgemm_");
  if (multiply == nullptr || dladdr(reinterpret_cast<void*>(multiply), &blas) == 0) return "";
  std::error_code none;
  std::string name = std::filesystem::canonical(blas.dli_fname, none).string();
  // LAPACK may come from another OpenBLAS than dgemm, so only the library of dgemm is searched.
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

/// Whether the address space has room for so many bytes; memory for them is not guaranteed.
bool has_addresses(std::size_t bytes) {
#if __has_include(<sys/mman.h>)
  void* place = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) return false;
  munmap(place, bytes);
#else
  (void)bytes;
#endif
  return true;
}

/// The OpenBLAS of this process, if there is one, and the number of living OneBlasThread objects.
class OpenBlas {
 public:
  /// A lock that a factorization must hold, too; empty where none is needed. Debian 12's OpenBLAS
  /// without threads (0.3.21) has locks of its own, and yet triangular solves of small blocks by
  /// two threads at once give wrong results (dtrsm; dtrsv does not).
  std::unique_lock<std::mutex> hold_alone() {
    const bool alone = parallel_ != nullptr && parallel_() == kNoThreads;
    return alone ? std::unique_lock(alone_) : std::unique_lock<std::mutex>();
  }
  /// Waits for a free work area. Throws std::bad_alloc when there is no memory for the first work
  /// area.
  void hold() {
    if (threads_ == nullptr || set_threads_ == nullptr || parallel_ == nullptr) return;
    std::unique_lock<std::mutex> lock(mutex_);
    if (holders_ == places_ && !add_place() && places_ == 0) throw std::bad_alloc();
    place_free_.wait(lock, [&] { return holders_ < places_; });
    if (holders_++ > 0) return;
    process_lock_.emplace(ProcessLock::Resource::kOpenBlas);
    if (parallel_() != kOwnThreads) return;
    before_ = threads_();
    if (before_ != 1) set_threads_(1);
  }
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (holders_ == 0) return;
    place_free_.notify_one();
    if (--holders_ > 0) return;
    if (before_ != 1 && threads_() == 1) set_threads_(before_);
    before_ = 1;
    process_lock_.reset();
  }

 private:
  /// Values of openblas_get_parallel(). An OpenBLAS with threads of its own has one thread count
  /// for the whole process.
  static constexpr int kNoThreads = 0, kOwnThreads = 1;

  /// OpenBLAS waits forever if the system refuses memory for a work area. The work areas that may
  /// be in use at once are therefore allocated here, where a refusal is detected; OpenBLAS keeps
  /// them.
  bool add_place() {
    constexpr std::size_t kBytes = std::size_t{160} << 20;  // 128 MiB and a margin
    constexpr int kMost = 16;
    const int places = places_ + 1;
    if (new_area_ != nullptr && free_area_ != nullptr && places <= kMost) {
      if (!has_addresses(static_cast<std::size_t>(places) * kBytes)) return false;
      void* areas[kMost] = {};
      for (int k = 0; k < places; ++k) areas[k] = new_area_(0);
      for (int k = 0; k < places; ++k) free_area_(areas[k]);
    }
    places_ = places;
    return true;
  }

  int (*threads_)() = find<int()>("openblas_get_num_threads");
  void (*set_threads_)(int) = find<void(int)>("openblas_set_num_threads");
  int (*parallel_)() = find<int()>("openblas_get_parallel");
  void* (*new_area_)(int) = find<void*(int)>("blas_memory_alloc");
  void (*free_area_)(void*) = find<void(void*)>("blas_memory_free");
  std::mutex alone_, mutex_;
  std::optional<ProcessLock> process_lock_;
  std::condition_variable place_free_;
  int holders_ = 0, places_ = 0;
  int before_ = 1;  // the thread count before the first holder
};

/// The object is never destroyed: a thread may still factor while static objects are destroyed.
OpenBlas& open_blas() {
  alignas(OpenBlas) static std::byte place[sizeof(OpenBlas)];
  static OpenBlas& found = *new (place) OpenBlas;
  return found;
}

/// OpenMP's settings, which each thread of the process has for itself. CHOLMOD's loops request four
/// threads explicitly, so no parallel level is allowed; OpenBLAS splits its work by the thread
/// count.
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

}  // namespace

std::string blas_library() {
  const std::string name = name_of_blas();
  return name.empty() ? "an unknown BLAS" : name;
}

OneBlasThread::OneBlasThread(BlasWork work) {
  if (work == BlasWork::kFactor) alone_ = open_blas().hold_alone();
  open_blas().hold();
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
  open_blas().release();
}

}  // namespace talweg

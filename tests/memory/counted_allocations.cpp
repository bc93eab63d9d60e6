// Counts every allocation of the process: malloc() and its relatives are replaced by the functions
// of the C library with a count.
#include "counted_allocations.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>

#include <malloc.h>

extern "C" {
void* __libc_malloc(std::size_t bytes);                     // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t count, std::size_t bytes);  // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* old, std::size_t bytes);         // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t alignment,
                      std::size_t bytes);  // NOLINT(bugprone-reserved-identifier)
void __libc_free(void* memory);            // NOLINT(bugprone-reserved-identifier)
}

namespace talweg::test {
namespace {

std::atomic<std::size_t> g_live = 0, g_peak = 0;

void* counted(void* memory) {
  if (memory == nullptr) return nullptr;
  const std::size_t live = g_live += malloc_usable_size(memory);
  std::size_t peak = g_peak;
  while (live > peak && !g_peak.compare_exchange_weak(peak, live)) {
  }
  return memory;
}
void uncount(void* memory) {
  if (memory != nullptr) g_live -= malloc_usable_size(memory);
}

}  // namespace

std::size_t live_bytes() { return g_live; }
std::size_t peak_bytes() { return g_peak; }
void begin_peak() { g_peak = g_live.load(); }

}  // namespace talweg::test

using talweg::test::counted;
using talweg::test::uncount;

extern "C" {
void* malloc(std::size_t bytes) { return counted(__libc_malloc(bytes)); }
void* calloc(std::size_t count, std::size_t bytes) { return counted(__libc_calloc(count, bytes)); }
void* realloc(void* old, std::size_t bytes) {
  uncount(old);
  void* moved = __libc_realloc(old, bytes);
  if (moved == nullptr && bytes > 0) counted(old);  // the old block still exists
  return counted(moved);
}
void* memalign(std::size_t alignment, std::size_t bytes) {
  return counted(__libc_memalign(alignment, bytes));
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  *memory = memalign(alignment, bytes);
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) {
  uncount(memory);
  __libc_free(memory);
}
}

#include "talweg/core/system/process.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace talweg {

std::uint64_t process_number() { return static_cast<std::uint64_t>(getpid()); }

std::uint64_t peak_memory_bytes() {
#if defined(__APPLE__)
  constexpr std::uint64_t kUnit = 1;
#else
  constexpr std::uint64_t kUnit = 1024;
#endif
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

}  // namespace talweg

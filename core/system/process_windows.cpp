#include <windows.h>

#include "talweg/core/system/process.hpp"
// Needs the types of the header above.
#include <psapi.h>

namespace talweg {

std::uint64_t process_number() { return GetCurrentProcessId(); }

std::uint64_t peak_memory_bytes() {
  PROCESS_MEMORY_COUNTERS used{};
  if (GetProcessMemoryInfo(GetCurrentProcess(), &used, sizeof used) == 0) return 0;
  return used.PeakWorkingSetSize;
}

}  // namespace talweg

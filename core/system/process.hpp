// The process: its id and its memory use, from the operating system.
#pragma once

#include <cstdint>

namespace talweg {

/// The id of this process. No other process has the same id at the same time.
std::uint64_t process_number();

/// The largest memory use of the process so far, in bytes; 0 if the system does not report it.
std::uint64_t peak_memory_bytes();

}  // namespace talweg

// The process as the system knows it.
#pragma once

#include <cstdint>

namespace talweg {

/// No other process has it at the same time.
std::uint64_t process_number();

/// The most that the process has had so far, in bytes; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

}  // namespace talweg

// Counted bytes that the process has from the allocator.
#pragma once

#include <cstddef>

namespace talweg::test {

[[nodiscard]] std::size_t live_bytes();
/// The most live bytes since begin_peak().
[[nodiscard]] std::size_t peak_bytes();
void begin_peak();

}  // namespace talweg::test

// Counted blocks are how much work a call does, whatever the machine and its other programs.
#pragma once

#include <cstdint>

namespace talweg::test {

/// The basic blocks that this thread has run so far in what is compiled with
/// -fsanitize-coverage=trace-pc; 0 where nothing is.
std::uint64_t blocks_run();

/// Calls `then` in this thread as soon as it has run that many more blocks; 0 for never.
void after_blocks(std::uint64_t count, void (*then)());

}  // namespace talweg::test

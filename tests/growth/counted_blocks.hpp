// Counted blocks are a measure of work that does not depend on the machine and its load.
#pragma once

#include <cstdint>

namespace talweg::test {

/// The number of basic blocks that this thread has run so far in code compiled with
/// -fsanitize-coverage=trace-pc; 0 without such code.
std::uint64_t blocks_run();

/// Calls `then` in this thread after `count` more blocks; 0 for never.
void after_blocks(std::uint64_t count, void (*then)());

}  // namespace talweg::test

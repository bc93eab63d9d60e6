#include "growth/counted_blocks.hpp"

namespace {

thread_local std::uint64_t blocks = 0, end = 0;
thread_local void (*at_end)() = nullptr;

}  // namespace

#ifndef TALWEG_BLOCK_CALLBACK
#define TALWEG_BLOCK_CALLBACK __sanitizer_cov_trace_pc
#endif

/// Called at the beginning of each basic block of code compiled with -fsanitize-coverage=trace-pc.
extern "C" void TALWEG_BLOCK_CALLBACK();  // NOLINT: the compilers' name
extern "C" void TALWEG_BLOCK_CALLBACK() {
  if (++blocks == end) at_end();
}

namespace talweg::test {

std::uint64_t blocks_run() { return blocks; }

void after_blocks(std::uint64_t count, void (*then)()) {
  end = count == 0 ? 0 : blocks + count;
  at_end = then;
}

}  // namespace talweg::test

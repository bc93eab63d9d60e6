#include "growth/counted_work.hpp"

#include <cmath>
#include <cstdio>

namespace {

thread_local std::uint64_t blocks = 0;

}  // namespace

/// Called at the begin of each basic block of what is compiled with -fsanitize-coverage=trace-pc.
extern "C" void __sanitizer_cov_trace_pc();  // NOLINT: the compilers' name
extern "C" void __sanitizer_cov_trace_pc() { ++blocks; }

namespace talweg::test {

std::uint64_t blocks_run() { return blocks; }

double exponent(const char* name, std::span<const Growth> growth) {
  const Growth &first = growth[growth.size() - 2], &last = growth.back();
  const double exponent =
      std::log(static_cast<double>(last.blocks) / static_cast<double>(first.blocks)) /
      std::log(static_cast<double>(last.n) / static_cast<double>(first.n));
  std::printf("  %-44s n^%.2f:", name, exponent);
  for (const Growth& g : growth) std::printf("  %zu: %.3g", g.n, static_cast<double>(g.blocks));
  std::printf("\n");
  return exponent;
}

}  // namespace talweg::test

#include "cost_limit.hpp"

#include "fuzz_bytes.hpp"
#include "growth/counted_blocks.hpp"

namespace talweg::fuzz {

CostLimit::CostLimit(double median, std::size_t size) : before_(test::blocks_run()) {
  const double most = kMostMedians * median * bytes_charged(size);
  test::after_blocks(static_cast<std::uint64_t>(most),
                     [] { require(false, "at most 50 times the usual cost of a byte"); });
}

CostLimit::~CostLimit() { test::after_blocks(0, nullptr); }

std::uint64_t CostLimit::blocks() const { return test::blocks_run() - before_; }

double bytes_charged(std::size_t size) { return static_cast<double>(size) + 64; }

}  // namespace talweg::fuzz

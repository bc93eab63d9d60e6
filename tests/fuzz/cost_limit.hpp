// A cost limit ends an input that is slow for its size. The cost is the number of basic blocks that
// run, which is the same however busy the machine is.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talweg::fuzz {

/// While it lives, this thread aborts once it has run kMostMedians times the blocks that an input
/// of that size usually runs. Only where blocks are counted (tests/growth).
class CostLimit {
 public:
  static constexpr double kMostMedians = 50;

  /// `median` is the target's, in blocks per byte (see bytes_charged); 0 for no limit.
  CostLimit(double median, std::size_t size);
  ~CostLimit();
  CostLimit(const CostLimit&) = delete;
  CostLimit& operator=(const CostLimit&) = delete;

  [[nodiscard]] std::uint64_t blocks() const;  ///< so far; 0 where they are not counted

 private:
  std::uint64_t before_;
};

/// The size, and an allowance for what every input costs, however small.
double bytes_charged(std::size_t size);

}  // namespace talweg::fuzz

// A cost limit aborts an input that is slow for its size. The cost is the number of basic blocks
// run, which does not depend on the load of the machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talweg::fuzz {

/// During its lifetime this thread aborts after kMostMedians times the usual number of blocks for
/// an input of this size. Only in builds that count blocks (tests/growth).
class CostLimit {
 public:
  static constexpr double kMostMedians = 50;

  /// `median` is the median cost of the target, in blocks per byte (see bytes_charged); 0 for no
  /// limit.
  CostLimit(double median, std::size_t size);
  ~CostLimit();
  CostLimit(const CostLimit&) = delete;
  CostLimit& operator=(const CostLimit&) = delete;

  [[nodiscard]] std::uint64_t blocks() const;  ///< run so far; 0 in builds that do not count blocks

 private:
  std::uint64_t before_;
};

/// The size plus an allowance for the fixed cost of an input.
double bytes_charged(std::size_t size);

}  // namespace talweg::fuzz

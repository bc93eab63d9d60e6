// A mixed order is a permutation whose consecutive numbers are far from each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>

namespace talweg {

/// A permutation of the numbers below `count`; every run of the order is spread evenly over the
/// numbers. Points along curves are inserted into triangulations in mixed order: in their own
/// order, each would change O(n) triangles. O(1) for a number.
class MixedOrder {
 public:
  explicit MixedOrder(std::size_t count) : count_(count) {
    if (count > 0) step_ = step_of(count);
  }
  /// The k-th number of the order.
  [[nodiscard]] std::size_t operator[](std::size_t k) const {
    return static_cast<std::size_t>(std::uint64_t{k} * step_ % count_);
  }

 private:
  static std::size_t step_of(std::size_t count) {
    std::size_t step = static_cast<std::size_t>(0.618 * static_cast<double>(count)) + 1;
    while (std::gcd(step, count) != 1) ++step;
    return step;
  }

  std::size_t count_, step_ = 1;
};

}  // namespace talweg

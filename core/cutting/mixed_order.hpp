// A mixed order takes numbers far from each other one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>

namespace talweg {

/// All numbers below `count`, with each part of the order spread evenly over them. Points along
/// curves are inserted into triangulations like that: in their own order each would change n
/// triangles. O(1) for a number.
class MixedOrder {
 public:
  explicit MixedOrder(std::size_t count) : count_(count) {
    if (count > 0) step_ = step_of(count);
  }
  /// The k-th number.
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

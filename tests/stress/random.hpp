// Random numbers that are the same with every compiler and library.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace talweg::stress {

/// splitmix64 (Steele, Lea & Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  /// A number in [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// A number in [low, high], low > 0, uniform in the logarithm.
  double scale(double low, double high) { return low * std::pow(high / low, unit()); }
  /// A number in [0, count), count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  std::uint32_t below32(std::size_t count) { return static_cast<std::uint32_t>(below(count)); }
  bool one_in(std::size_t count) { return below(count) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace talweg::stress

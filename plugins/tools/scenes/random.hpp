// A small random generator with the same numbers on every machine.
#pragma once

#include <cstdint>

namespace talweg::scenes {

/// A well-mixed 64-bit hash of a counter (the finalizer of SplitMix64, Steele et al. 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mix_bits(seed)) {}

  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(mix_bits(state_++) >> 11U) * 0x1p-53; }
  /// Uniform in [low, high).
  double in(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

}  // namespace talweg::scenes

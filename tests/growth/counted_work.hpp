// Counted work shows how the cost of a call grows with its input, independently of the machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "growth/counted_blocks.hpp"

namespace talweg::test {

struct Growth {
  std::size_t n = 0;
  std::uint64_t blocks = 0;
};

/// The exponent of growth between the last two sizes. Prints all sizes; the smaller sizes show
/// where the exponent begins to hold.
double exponent(const char* name, std::span<const Growth> growth);

/// Expects that between the last two sizes the work grows by at most n^`most`. `prepare(n)` makes
/// the input and returns the call to count.
template <class Prepare>
void expect_growth(const char* name, double most, std::initializer_list<std::size_t> sizes,
                   const Prepare& prepare) {
  std::vector<Growth> growth;
  for (const std::size_t n : sizes) {
    auto call = prepare(n);
    const std::uint64_t before = blocks_run();
    call();
    growth.push_back({n, blocks_run() - before});
  }
  EXPECT_LE(exponent(name, growth), most) << name;
}

}  // namespace talweg::test

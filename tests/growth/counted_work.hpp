// Counted work tells how what a call does grows with its input, whatever the machine.
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

/// The exponent between the last two sizes; prints all. The smaller ones show from where on it
/// holds.
double exponent(const char* name, std::span<const Growth> growth);

/// Requires that the work for each larger input is at most n^`most` times that of the smaller one,
/// at the last two of these sizes. `prepare(n)` makes the input and returns the call to count.
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

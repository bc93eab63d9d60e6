// A cost table has the median cost of the files of a corpus, for CostLimit, and the largest costs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cost_limit.hpp"

namespace talweg::fuzz {

/// Prints the table. `blocks_of(data, size)` runs an input.
template <class Run>
void print_costs(const std::vector<std::string>& files, const Run& blocks_of) {
  std::vector<std::pair<double, std::string>> costs;
  for (const std::string& name : files) {
    std::ifstream in(name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const auto blocks = static_cast<double>(blocks_of(data, bytes.size()));
    costs.emplace_back(blocks / bytes_charged(bytes.size()), name);
  }
  if (costs.empty()) return;
  std::sort(costs.begin(), costs.end());
  const double median = costs[costs.size() / 2].first;
  std::printf("median %.4g blocks per byte, %zu files; the most, in medians:\n", median,
              costs.size());
  for (std::size_t k = costs.size(); k > 0 && k + 5 > costs.size(); --k) {
    std::printf("  %.3g %s\n", costs[k - 1].first / median, costs[k - 1].second.c_str());
  }
}

}  // namespace talweg::fuzz

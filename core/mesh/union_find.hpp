// Union-find joins numbered elements to disjoint sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace talweg {

/// Sets are joined under their smallest element, so results do not depend on the order of joins.
/// O(log n) amortised for each call, memory for n elements.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace talweg

#include "growth/counted_work.hpp"

#include <cmath>
#include <cstdio>

namespace talweg::test {

double exponent(const char* name, std::span<const Growth> growth) {
  const Growth &first = growth[growth.size() - 2], &last = growth.back();
  const double exponent =
      std::log(static_cast<double>(last.blocks) / static_cast<double>(first.blocks)) /
      std::log(static_cast<double>(last.n) / static_cast<double>(first.n));
  std::printf("  %-44s n^%.2f:", name, exponent);
  for (const Growth& g : growth) std::printf("  %zu: %.3g", g.n, static_cast<double>(g.blocks));
  std::printf("\n");
  return exponent;
}

}  // namespace talweg::test

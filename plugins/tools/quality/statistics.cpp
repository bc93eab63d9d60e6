#include "tools/quality/statistics.hpp"

#include <algorithm>
#include <cstddef>

namespace talweg::quality {

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  const double f = at - static_cast<double>(i);
  return i + 1 < values.size() ? values[i] * (1 - f) + values[i + 1] * f : values[i];
}

double share_within(std::span<const double> values, double bound) {
  if (values.empty()) return 1;
  const auto good =
      std::count_if(values.begin(), values.end(), [bound](double value) { return value <= bound; });
  return static_cast<double>(good) / static_cast<double>(values.size());
}

}  // namespace talweg::quality

#include "talweg/intrinsic/exact_distance/shorter_parts.hpp"

#include <algorithm>

namespace talweg {
namespace {

/// Calls keep(from, to) for the parts of [begin, end] outside [low, high], the overlap with another
/// window, and for the parts of the overlap where the new window is shorter (`won`). A won part
/// that reaches an end of the overlap is joined with the part beyond this end.
template <class Keep>
void keep_around(double begin, double end, double low, double high, const Stretches& won,
                 Keep keep) {
  bool any = begin < low;  // whether a stretch is open, from `open` until `until`
  double open = any ? begin : high;
  double until = any ? low : high;
  const auto take = [&](double from, double to) {
    if (any && from <= until) {
      until = to;
      return;
    }
    if (any) keep(open, until);
    open = from;
    until = to;
    any = true;
  };
  for (int k = 0; k < won.count; ++k) {
    const auto [from, to] = won.at[k];
    take(from, to);
  }
  if (high < end) take(high, end);
  if (any) keep(open, until);
}

}  // namespace

void ShorterParts::compare_with(EdgeWindow& other) {
  Parts kept;
  const auto keep = [&](double from, double to) {
    if (to - from > kNarrow * kBorder * size_ || length_ <= 0) kept.add(from, to);
  };
  for (const auto& [begin, end] : parts()) {
    const double low = std::max(begin, other.begin), high = std::min(end, other.end);
    if (other.is_empty() || low > high) {
      kept.add(begin, end);
      continue;
    }
    const double border = kBorder * std::min(size_, size_of(other, length_));
    const Stretches won = where_below(*window_, other, low, high, same_, border);
    keep_around(begin, end, low, high, won, keep);
    for (int k = 0; k < won.count; ++k) {
      other.cut(won.at[k][0], won.at[k][1], 2 * border, kNarrow * border);
    }
  }
  parts_.take(kept);
}

}  // namespace talweg

#include "talweg/core/canonical_order.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/core/measures.hpp"

namespace talweg {
namespace {

using Sequence = std::vector<long long>;

/// Where the lexicographically least rotation begins.
std::size_t least_rotation(const Sequence& s) {
  const std::size_t n = s.size();
  std::size_t i = 0, j = 1, same = 0;
  while (i < n && j < n && same < n) {
    const long long a = s[(i + same) % n], b = s[(j + same) % n];
    if (a == b) {
      ++same;
      continue;
    }
    std::size_t& worse = a > b ? i : j;
    worse += same + 1;
    if (i == j) ++j;
    same = 0;
  }
  return std::min(i, j);
}

Sequence rotated(const Sequence& s, std::size_t start) {
  Sequence result(s.begin() + static_cast<std::ptrdiff_t>(start), s.end());
  result.insert(result.end(), s.begin(), s.begin() + static_cast<std::ptrdiff_t>(start));
  return result;
}

Sequence all_lengths(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  const double whole = curve_length(surface, curve);
  Sequence lengths;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const double length =
        curve_length(surface, {false, {curve.points[i], curve.points[(i + 1) % n]}});
    lengths.push_back(whole > 0 ? std::llround(1e9 * (length / whole)) : 0);
  }
  return lengths;
}

}  // namespace

CurveOrder canonical_order(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  if (n < 2) return {};
  const Sequence forward = all_lengths(surface, curve);
  const Sequence backward(forward.rbegin(), forward.rend());
  if (!curve.closed) return backward < forward ? CurveOrder{n - 1, true} : CurveOrder{};
  const std::size_t start = least_rotation(forward), other = least_rotation(backward);
  // Segment i of the backward sequence leads from point n - i to the one before it.
  if (rotated(backward, other) < rotated(forward, start)) return {(n - other) % n, true};
  return {start, false};
}

SurfaceCurve in_order(const SurfaceCurve& curve, const CurveOrder& order) {
  const std::size_t n = curve.points.size();
  SurfaceCurve result{curve.closed, {}};
  result.points.reserve(n);
  for (std::size_t k = 0; k < n; ++k)
    result.points.push_back(curve.points[order.drawn_index(k, n)]);
  return result;
}

}  // namespace talweg

#include "talweg/core/drawing/canonical_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

using Letter = long long;
using Sequence = std::vector<Letter>;

/// The sum of terms in ascending order: no order of the terms changes a bit of the sum.
double sum_of(std::vector<double> terms) {
  std::sort(terms.begin(), terms.end());
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

std::vector<std::array<double, 3>> places_of(const SurfaceMesh& mesh,
                                             const std::vector<SurfacePoint>& points) {
  std::vector<std::array<double, 3>> places;
  places.reserve(points.size());
  for (const SurfacePoint& point : points) {
    const Point at = mesh.position(point);
    places.push_back({at.x(), at.y(), at.z()});
  }
  return places;
}

/// The start of the lexicographically least rotation.
std::size_t least_rotation(const Sequence& s) {
  const std::size_t n = s.size();
  std::size_t i = 0, j = 1, same = 0;
  while (i < n && j < n && same < n) {
    const Letter a = s[(i + same) % n], b = s[(j + same) % n];
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

/// The smallest rotation that maps a sequence to itself.
std::size_t period_of(const Sequence& s) {
  const std::size_t n = s.size();
  std::vector<std::size_t> border(n + 1, 0);  // border[k]: border length of the first k letters
  for (std::size_t i = 1, k = 0; i < n; ++i) {
    while (k > 0 && s[i] != s[k]) k = border[k];
    border[i + 1] = k += s[i] == s[k] ? 1 : 0;
  }
  const std::size_t period = n - border[n];
  return n % period == 0 ? period : n;
}

Sequence rotated(const Sequence& s, std::size_t start) {
  Sequence result(s.begin() + static_cast<std::ptrdiff_t>(start), s.end());
  result.insert(result.end(), s.begin(), s.begin() + static_cast<std::ptrdiff_t>(start));
  return result;
}

template <class Key>
Sequence ranks_of(const std::vector<Key>& keys) {
  std::vector<Key> sorted = keys;
  std::sort(sorted.begin(), sorted.end());
  Sequence ranks;
  ranks.reserve(keys.size());
  for (const Key& key : keys) {
    ranks.push_back(std::lower_bound(sorted.begin(), sorted.end(), key) - sorted.begin());
  }
  return ranks;
}

/// The starts of a closed curve that no sequence has told apart yet, in one direction: first,
/// first + period, ...
struct Starts {
  std::size_t first = 0, period = 1;

  /// Keeps the starts with the lexicographically least rotation of the sequence, and returns that
  /// rotation.
  Sequence choose(const Sequence& letters) {
    const Sequence turned = rotated(letters, first);
    std::vector<Sequence> blocks;
    for (auto at = turned.begin(); at != turned.end();) {
      const auto begin = std::exchange(at, at + static_cast<std::ptrdiff_t>(period));
      blocks.emplace_back(begin, at);
    }
    const Sequence ranks = period > 1 ? ranks_of(blocks) : turned;
    const std::size_t least = least_rotation(ranks), shift = least * period;
    first = (first + shift) % letters.size();
    period *= period_of(ranks);
    return rotated(turned, shift);
  }
};

/// The sequences by which the directions and starts of a curve are compared: lengths of segments,
/// then turns at points, then positions of points. A letter belongs to a point or a segment.
class Comparison {
 public:
  Comparison(const SurfaceMesh& mesh, const SurfaceCurve& curve)
      : mesh_(mesh), surface_(mesh.surface()), points_(curve.points), closed_(curve.closed) {}

  static constexpr int kLevels = 3;

  /// The sequence of the curve, and the sequence of the reversed curve.
  [[nodiscard]] std::array<Sequence, 2> letters(int level) const {
    Sequence forward = level == 0 ? lengths() : level == 1 ? turns() : positions();
    Sequence backward(forward.rbegin(), forward.rend());
    if (level == 1) {
      for (Letter& turn : backward) turn = -turn;
    }
    // The first segment of the reversed curve ends at the last point but one.
    if (level == 0 && closed_) std::rotate(backward.begin(), backward.begin() + 1, backward.end());
    return {forward, backward};
  }

 private:
  [[nodiscard]] const SurfacePoint& point(std::size_t i) const {
    return points_[i % points_.size()];
  }

  /// The lengths of the segments, as billionths of the curve's length.
  [[nodiscard]] Sequence lengths() const {
    std::vector<double> own;
    for (std::size_t i = 0; i + (closed_ ? 0 : 1) < points_.size(); ++i) {
      own.push_back(curve_length(surface_, {false, {point(i), point(i + 1)}}));
    }
    const double whole = sum_of(own);
    Sequence result;
    result.reserve(own.size());
    for (const double length : own) {
      result.push_back(whole > 0 ? std::llround(1e9 * (length / whole)) : 0);
    }
    return result;
  }

  /// The turns at the points, in billionths of a radian: the mean of the turns in both directions,
  /// so that the reversed curve has the negative values. The turn of a curve that turns back is 0.
  [[nodiscard]] Sequence turns() const {
    const std::size_t n = points_.size();
    Sequence result(n, 0);
    for (std::size_t i = closed_ ? 0 : 1; i + (closed_ ? 0 : 1) < n; ++i) {
      const SurfacePoint &before = point(i + n - 1), &after = point(i + 1);
      result[i] = std::llround(5e8 * signed_turning(surface_, before, point(i), after)) -
                  std::llround(5e8 * signed_turning(surface_, after, point(i), before));
    }
    return result;
  }

  [[nodiscard]] Sequence positions() const { return ranks_of(places_of(mesh_, points_)); }

  const SurfaceMesh& mesh_;
  const Surface& surface_;
  const std::vector<SurfacePoint>& points_;
  bool closed_;
};

}  // namespace

CurveOrder canonical_order(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  if (n < 2) return {};
  const Comparison comparison(mesh, curve);
  Starts ahead, back;
  bool may_go_ahead = true, may_go_back = true;
  const auto is_clear = [&](const Starts& starts) { return !curve.closed || starts.period == n; };
  for (int level = 0; level < Comparison::kLevels; ++level) {
    if (may_go_ahead != may_go_back && is_clear(may_go_ahead ? ahead : back)) break;
    auto [forward, backward] = comparison.letters(level);
    if (curve.closed && may_go_ahead) forward = ahead.choose(forward);
    if (curve.closed && may_go_back) backward = back.choose(backward);
    if (!may_go_ahead || !may_go_back) continue;
    may_go_ahead = !(backward < forward);
    may_go_back = !(forward < backward);
  }
  if (may_go_ahead) return {ahead.first, false};
  return {n - 1 - back.first, true};
}

std::vector<std::size_t> canonical_set_order(const SurfaceMesh& mesh,
                                             const std::vector<SurfaceCurve>& ordered) {
  std::vector<double> lengths;
  lengths.reserve(ordered.size());
  for (const SurfaceCurve& curve : ordered) lengths.push_back(curve_length(mesh.surface(), curve));
  const double whole = sum_of(lengths);
  const auto share = [&](std::size_t c) {
    return whole > 0 ? std::llround(1e9 * (lengths[c] / whole)) : 0;
  };
  const auto is_first = [&](std::size_t a, std::size_t b) {
    const SurfaceCurve &p = ordered[a], &q = ordered[b];
    if (p.closed != q.closed) return q.closed;
    if (p.points.size() != q.points.size()) return p.points.size() < q.points.size();
    if (share(a) != share(b)) return share(a) < share(b);
    return places_of(mesh, p.points) < places_of(mesh, q.points);
  };
  std::vector<std::size_t> order(ordered.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), is_first);
  return order;
}

SurfaceCurve in_order(const SurfaceCurve& curve, const CurveOrder& order) {
  const std::size_t n = curve.points.size();
  SurfaceCurve result{curve.closed, {}};
  result.points.reserve(n);
  for (std::size_t k = 0; k < n; ++k)
    result.points.push_back(curve.points[order.drawn_index(k, n)]);
  return result;
}

CurveMeasures turned_back(CurveMeasures measures, const CurveOrder& order, std::size_t points) {
  measures.max_at = order.drawn_index(measures.max_at, points);
  if (order.reversed) measures.signed_curvature = -measures.signed_curvature;
  return measures;
}

}  // namespace talweg

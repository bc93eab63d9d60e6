// A stretch is the part of a line on which a convex function stays below a limit.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace talweg {

/// A part of a line; both numbers are distances from the start of the line.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// The place between `inside`, where f is at most `limit`, and `outside`, where f is greater, at
/// which a convex f reaches the limit, up to rounding.
template <class F>
double limit_between(const F& f, double inside, double outside, double limit) {
  constexpr int kMost = 100;
  constexpr double kSame = 1e-15;
  double f_inside = f(inside) - limit, f_outside = f(outside) - limit;
  const double width = std::abs(outside - inside);
  for (int i = 0; i < kMost && std::abs(outside - inside) > kSame * width; ++i) {
    // A convex function lies below its chord, so steps along the chord move one end only. Every
    // other step therefore halves the interval.
    const double part = i % 2 == 0 ? f_inside / (f_inside - f_outside) : 0.5;
    const double x = inside + part * (outside - inside), f_x = f(x) - limit;
    if (std::abs(f_x) <= kSame * std::abs(limit)) return x;
    (f_x <= 0 ? inside : outside) = x;
    (f_x <= 0 ? f_inside : f_outside) = f_x;
  }
  return inside;
}

/// A place in [0, length] where a convex function of Lipschitz constant 1 is at most `limit`; none
/// if there is no such place. Golden-section search, which ends as soon as a place is found or
/// excluded.
template <class F>
std::optional<double> place_below(const F& f, double length, double limit) {
  constexpr double kGolden = 0.6180339887498949, kShort = 1e-12;
  double low = 0, high = length;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double f_left = f(left), f_right = f(right);
  while (high - low > kShort * length) {
    if (f_left <= limit) return left;
    if (f_right <= limit) return right;
    if (std::min(f_left, f_right) - kGolden * (high - low) > limit) return {};
    if (f_left < f_right) {
      high = right;
      right = left;
      f_right = f_left;
      f_left = f(left = high - kGolden * (high - low));
    } else {
      low = left;
      left = right;
      f_left = f_right;
      f_right = f(right = low + kGolden * (high - low));
    }
  }
  return {};
}

/// The part of [0, length] where a convex function of Lipschitz constant 1 is at most `limit`.
template <class F>
std::optional<Stretch> stretch_below(const F& f, double length, double limit) {
  const double first = f(0), last = f(length);
  if (first <= limit && last <= limit) return Stretch{0, length};
  if (first <= limit) return Stretch{0, limit_between(f, 0, length, limit)};
  if (last <= limit) return Stretch{limit_between(f, length, 0, limit), length};
  if (!(first + last - length <= 2 * limit)) return {};
  const std::optional<double> place = place_below(f, length, limit);
  if (!place) return {};
  return Stretch{limit_between(f, *place, 0, limit), limit_between(f, *place, length, limit)};
}

/// The union of stretches, sorted; stretches at most `gap` apart are joined.
inline std::vector<Stretch> joined_stretches(std::vector<Stretch> stretches, double gap) {
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> joined;
  for (const Stretch& s : stretches) {
    if (!joined.empty() && s.from <= joined.back().to + gap) {
      joined.back().to = std::max(joined.back().to, s.to);
    } else {
      joined.push_back(s);
    }
  }
  return joined;
}

}  // namespace talweg

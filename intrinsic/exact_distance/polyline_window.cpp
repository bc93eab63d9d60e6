#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

#include <algorithm>
#include <limits>

namespace talweg {

double EdgeWindow::lowest() const {
  if (from_point()) return value(std::clamp(px, begin, end));
  return value(px > 0 ? begin : end);
}

void EdgeWindow::cut(double from, double to, double overlap, double narrow) {
  if (from <= begin + narrow && to >= end - narrow) {
    begin = 1;
    end = 0;
  } else if (from <= begin + narrow) {
    begin = std::max(begin, to - overlap);
  } else if (to >= end - narrow) {
    end = std::min(end, from + overlap);
  }
}

bool EdgeWindow::bends_towards(double x, double rise, double& at) const {
  double crossing = x;
  if (rise > 0) {
    crossing = from_point() ? px + (x - px) * std::abs(py) / (rise + std::abs(py))
                            : x - px / std::abs(py) * rise;
  }
  if (crossing >= begin && crossing <= end) return false;
  at = crossing > end ? end : begin;
  return true;
}

double EdgeWindow::value_beyond(double x, double y, double& arc_length) const {
  const double rise = std::abs(y);
  double bend = 0;
  if (bends_towards(x, rise, bend)) {
    arc_length = arc_at(bend);
    return value(bend) + std::sqrt((x - bend) * (x - bend) + rise * rise);
  }
  arc_length = from_point() ? arc : arc + arc_sign * (py * x - px * y);
  if (!from_point()) return offset + px * x + py * y;
  const double across = x - px, along = rise + std::abs(py);
  return offset + std::sqrt(across * across + along * along);
}

EdgeWindow EdgeWindow::turned(double length) const {
  EdgeWindow w = *this;
  w.begin = length - end;
  w.end = length - begin;
  if (from_point()) {
    w.px = length - px;
    w.py = -py;
  } else {
    w.offset = value(length);
    w.arc = arc_at(length);
    w.px = -px;
    w.py = -py;
  }
  return w;
}

namespace {

/// The place where both functions have equal slopes; NaN if there is none.
double critical_point(const EdgeWindow& a, const EdgeWindow& b) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (a.from_point() && b.from_point()) {
    const double p = std::abs(a.py), q = std::abs(b.py);
    return p == q ? kNone : (a.px * q - b.px * p) / (q - p);
  }
  if (!a.from_point() && !b.from_point()) return kNone;
  const EdgeWindow& point = a.from_point() ? a : b;
  const EdgeWindow& segment = a.from_point() ? b : a;
  if (segment.px == 0) return point.px;
  return point.px + std::abs(point.py) * segment.px / std::abs(segment.py);
}

struct Rise {
  double value, slope;
};
/// Computes value() and slope() with a single square root.
Rise rise(const EdgeWindow& w, double x) {
  if (!w.from_point()) return {w.offset + w.px * x, w.px};
  const double r = std::sqrt((x - w.px) * (x - w.px) + w.py * w.py);
  return {w.offset + r, r > 0 ? (x - w.px) / r : 0.0};
}

/// A zero of a - b + shift between low and high, where the signs differ, to within `precision` in
/// value or in x: Newton's method, kept inside the interval.
double crossing(const EdgeWindow& a, const EdgeWindow& b, double shift, double low, double f_low,
                double high, double f_high, double precision) {
  double x = low + (high - low) * (f_low / (f_low - f_high));
  for (int i = 0; i < 60 && high - low > precision; ++i) {
    const Rise at_a = rise(a, x), at_b = rise(b, x);
    const double fx = at_a.value - at_b.value + shift;
    if (std::abs(fx) <= precision) break;
    ((fx < 0) == (f_low < 0) ? low : high) = x;
    const double step = fx / (at_a.slope - at_b.slope);
    x = x - step > low && x - step < high ? x - step : low + (high - low) / 2;
  }
  return x;
}

}  // namespace

Stretches where_below(const EdgeWindow& a, const EdgeWindow& b, double low, double high,
                      double tolerance, double resolution) {
  const auto f = [&](double x) { return a.value(x) - b.value(x) + tolerance; };
  const auto border = [&](double from, double f_from, double to, double f_to) {
    return crossing(a, b, tolerance, from, f_from, to, f_to, resolution / 4);
  };
  Stretches result;
  const auto add = [&](double from, double to) {
    result.at[static_cast<std::size_t>(result.count++)] = {std::max(from, low), std::min(to, high)};
  };
  const double f_low = f(low), f_high = f(high);
  if ((f_low < 0) != (f_high < 0)) {
    const double middle = border(low, f_low, high, f_high);
    if (f_low < 0) {
      add(low, middle + resolution);
    } else {
      add(middle - resolution, high);
    }
    return result;
  }
  const double turn = critical_point(a, b);
  const double f_turn = turn > low && turn < high ? f(turn) : f_low;
  if ((f_turn < 0) == (f_low < 0)) {
    if (f_low < 0) add(low, high);
    return result;
  }
  const double first = border(low, f_low, turn, f_turn);
  const double second = border(turn, f_turn, high, f_high);
  if (f_low < 0) {
    add(low, first + resolution);
    add(second - resolution, high);
  } else {
    add(first - resolution, second + resolution);
  }
  return result;
}

}  // namespace talweg

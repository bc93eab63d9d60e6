#include "talweg/core/measure/turning_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace talweg {
namespace {

constexpr double kRounding = 1e-9;  // relative

/// Slides a window along the curve and calls visit(from, to, sum) for each range of positions in
/// which the window contains the same turns. `from` and `to` are arc lengths of the window's end,
/// `sum` the sum of the turns. On a closed curve the end runs around once, on an open curve until
/// the window has left the curve. For two turns exactly one window apart, the second enters before
/// the first leaves.
template <class Visit>
void slide(const CurveTurns& turns, double window, const Visit& visit) {
  const std::size_t n = turns.at.size();
  const double stop = turns.closed ? turns.length : turns.length + window;
  // Turn k leaves the window as number n + k. On a closed curve a turn k may be in the window at
  // the start; it then also leaves as number k.
  const auto leaves_at = [&](std::size_t number) {
    return turns.at[number % n] + window - (number < n ? turns.length : 0);
  };
  std::size_t enter = 0, leave = turns.closed ? 0 : n;
  while (leave < n && leaves_at(leave) <= 0) ++leave;
  double sum = 0, end = 0;
  for (std::size_t k = leave; k < n; ++k) sum += turns.angle[k];
  for (;;) {
    const bool enters = enter < n && turns.at[enter] <= leaves_at(leave);
    const double at = enters ? turns.at[enter] : leave < 2 * n ? leaves_at(leave) : stop;
    visit(end, std::min(at, stop), sum);
    if (at >= stop && !enters) return;
    end = at;
    sum += enters ? turns.angle[enter++] : -turns.angle[leave++ % n];
  }
}

/// The window, made shorter than a loop: a longer window would count a turn twice.
double fitted(const CurveTurns& turns, double window) {
  return turns.closed ? std::min(window, (1 - kRounding) * turns.length) : window;
}

}  // namespace

double bending(const CurveTurns& turns, double edge) {
  const double window = fitted(turns, edge / 2);
  if (turns.at.empty() || !(window > 0)) return 0;
  double integral = 0;
  slide(turns, window, [&](double from, double to, double sum) {
    integral += (to - from) * (sum / window) * (sum / window);
  });
  return edge * integral;
}

std::vector<CurvatureStep> curvature_along(const CurveTurns& turns, double window) {
  std::vector<CurvatureStep> steps, behind_start;
  if (!(turns.length > 0) || !(window > 0)) return steps;
  window = fitted(turns, window);
  const auto add = [](std::vector<CurvatureStep>& to, const CurvatureStep& step) {
    if (step.to > step.from) to.push_back(step);
  };
  slide(turns, window, [&](double from, double to, double sum) {
    const double a = from - window / 2, b = to - window / 2, curvature = sum / window;
    add(steps, {std::max(a, 0.0), std::min(b, turns.length), curvature});
    // The first windows of a loop are centred before its start.
    if (!turns.closed) return;
    add(behind_start, {a + turns.length, std::min(b, 0.0) + turns.length, curvature});
  });
  steps.insert(steps.end(), behind_start.begin(), behind_start.end());
  return steps;
}

double window_turning(const CurveTurns& turns, double window) {
  // Turns exactly one window apart count together in spite of rounding.
  if (turns.at.empty() || !(window > 0)) return 0;
  double largest = 0;
  slide(turns, fitted(turns, (1 + kRounding) * window),
        [&](double, double, double sum) { largest = std::max(largest, std::abs(sum)); });
  return largest;
}

}  // namespace talweg

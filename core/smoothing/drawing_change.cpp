#include "talweg/core/smoothing/drawing_change.hpp"

#include <algorithm>
#include <vector>

namespace talweg {
namespace {

using Points = std::vector<SurfacePoint>;

/// Counts the equal points at the front and, among the remaining points, at the back.
void count_kept(DrawingChange& change) {
  const Points &a = change.before.points, &b = change.after.points;
  const auto front = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  change.kept_before = static_cast<std::size_t>(front.first - a.begin());
  const auto left_a = a.size() - change.kept_before, left_b = b.size() - change.kept_before;
  const auto most = static_cast<std::ptrdiff_t>(std::min(left_a, left_b));
  const auto back = std::mismatch(a.rbegin(), a.rbegin() + most, b.rbegin());
  change.kept_after = static_cast<std::size_t>(back.first - a.rbegin());
}

void turn(Points& points, std::size_t start) {
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start), points.end());
}

std::size_t kept(const DrawingChange& change) { return change.kept_before + change.kept_after; }

/// Rotates both loops to begin with a common point, chosen from four so that most points are kept.
DrawingChange change_of_loop(const SurfaceCurve& before, const SurfaceCurve& after) {
  DrawingChange best{before, after};
  const std::size_t n = before.points.size();
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t start = k * n / 4;
    const auto found = std::find(after.points.begin(), after.points.end(), before.points[start]);
    if (found == after.points.end()) continue;
    DrawingChange change{before, after};
    turn(change.before.points, start);
    turn(change.after.points, static_cast<std::size_t>(found - after.points.begin()));
    count_kept(change);
    if (kept(change) > kept(best)) best = std::move(change);
    if (2 * kept(best) > n) break;  // no other common stretch can be longer
  }
  return best;
}

/// Moves the seam into the middle of the kept points.
void balance(DrawingChange& change) {
  const std::size_t all = kept(change), front = all / 2;
  for (Points* points : {&change.before.points, &change.after.points}) {
    const std::size_t n = points->size();
    turn(*points, (n + change.kept_before - front) % n);
  }
  change.kept_before = front;
  change.kept_after = all - front;
}

}  // namespace

DrawingChange change_between(const SurfaceCurve& before, const SurfaceCurve& after) {
  DrawingChange change{before, after};
  if (before.closed != after.closed || before.points.empty() || after.points.empty()) return change;
  if (!before.closed) {
    count_kept(change);
    return change;
  }
  change = change_of_loop(before, after);
  const bool none = change.is_none();
  if (kept(change) > 0 && !none) balance(change);
  return change;
}

}  // namespace talweg

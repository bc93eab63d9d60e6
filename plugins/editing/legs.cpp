#include "legs.hpp"

#include <algorithm>
#include <limits>

#include "drawing.hpp"

namespace talweg::editing {
namespace {

double squared_distance(const Vector& a, const Vector& b) {
  const Vector d = minus(a, b);
  return dot(d, d);
}

/// Assigns to each given point a point of the line, in order, so that the sum of the squared
/// distances is least. The order keeps near stretches of a returning line apart. Returns indices of
/// the line's points, one per given point.
std::vector<std::size_t> passed_at(const std::vector<Vector>& given,
                                   const std::vector<Vector>& line) {
  const std::size_t n = given.size(), m = line.size();
  // best[j]: the least sum for the points so far, with the last point at j or before. stays[i m +
  // j]: an assignment of point i before j is as good as one at j.
  std::vector<double> best(m, 0);
  std::vector<bool> stays(n * m);
  for (std::size_t i = 0; i < n; ++i) {
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < m; ++j) {
      const double here = best[j] + squared_distance(given[i], line[j]);
      stays[i * m + j] = before <= here;
      before = best[j] = std::min(before, here);
    }
  }
  std::vector<std::size_t> at(n);
  std::size_t j = m - 1;
  for (std::size_t i = n; i-- > 0;) {
    while (stays[i * m + j]) --j;
    at[i] = j;
  }
  return at;
}

/// The closed line as an open line that begins and ends at its point `first`.
std::vector<Vector> turned(const std::vector<Vector>& line, std::size_t first) {
  std::vector<Vector> result(line.begin() + static_cast<std::ptrdiff_t>(first), line.end());
  result.insert(result.end(), line.begin(), line.begin() + static_cast<std::ptrdiff_t>(first));
  result.push_back(result.front());
  return result;
}

}  // namespace

std::size_t leg_at(const std::vector<Vector>& given, const std::vector<Vector>& line, bool closed,
                   std::size_t segment) {
  const std::size_t segments = line.size() - (closed || line.empty() ? 0 : 1);
  if (given.size() < 2 || segment >= segments) throw Error("There is no such part of the curve.");
  std::size_t before = 0;
  if (closed) {
    const auto nearest =
        std::min_element(line.begin(), line.end(), [&](const Vector& a, const Vector& b) {
          return squared_distance(a, given[0]) < squared_distance(b, given[0]);
        });
    const auto first = static_cast<std::size_t>(nearest - line.begin());
    const std::vector<std::size_t> at = passed_at(given, turned(line, first));
    const std::size_t from_first = (segment + line.size() - first) % line.size();
    before =
        static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), from_first) - at.begin());
    return std::max<std::size_t>(before, 1);
  }
  const std::vector<std::size_t> at = passed_at(given, line);
  before = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), segment) - at.begin());
  return std::clamp<std::size_t>(before, 1, given.size() - 1);
}

}  // namespace talweg::editing

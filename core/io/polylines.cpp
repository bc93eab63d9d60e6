#include "talweg/core/io/polylines.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace talweg::formats {
namespace {

/// The marks of a line's points. The last point of a closed line is a copy of the first; its mark
/// counts if the first has none.
std::vector<double> marks_along(const Line& line, bool closed, std::span<const double> marks) {
  std::vector<double> result;
  for (const std::uint32_t k : line) result.push_back(marks[k]);
  if (!closed) return result;
  if (result.front() == kNotSaid) result.front() = result.back();
  result.pop_back();
  return result;
}

/// Gives segments of two points that meet at equal positions the same point index there, so that
/// they are joined like segments that share an index.
void join_segments(std::span<const Point> points, std::vector<Line>& lines) {
  std::vector<std::uint32_t> ends;
  for (const Line& line : lines) {
    if (line.size() == 2) ends.insert(ends.end(), line.begin(), line.end());
  }
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const Point &p = points[a], &q = points[b];
    return std::tuple(p.x(), p.y(), p.z(), a) < std::tuple(q.x(), q.y(), q.z(), b);
  };
  std::sort(ends.begin(), ends.end(), before);
  std::unordered_map<std::uint32_t, std::uint32_t> first;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const bool same = k > 0 && points[ends[k]] == points[ends[k - 1]];
    first.emplace(ends[k], same ? first.at(ends[k - 1]) : ends[k]);
  }
  for (Line& line : lines) {
    if (line.size() != 2) continue;
    const std::uint32_t a = first.at(line[0]), b = first.at(line[1]);
    if (a != b) line = {a, b};
  }
}

}  // namespace

std::vector<CurveInput> curves_of(std::span<const Point> points, std::vector<Line> lines,
                                  std::span<const double> marks) {
  std::vector<CurveInput> curves;
  join_segments(points, lines);
  for (const Line& line : joined(std::move(lines))) {
    CurveInput curve;
    const bool same_index = line.front() == line.back();
    const bool same_place = line.size() >= 4 && points[line.front()] == points[line.back()];
    curve.closed = line.size() > 1 && (same_index || same_place);
    std::vector<Point> positions;
    for (std::size_t k = 0; k < line.size() - (curve.closed ? 1 : 0); ++k) {
      positions.push_back(points[line[k]]);
    }
    curve.points = std::move(positions);
    if (!marks.empty()) set_marks(curve, marks_along(line, curve.closed, marks));
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace talweg::formats

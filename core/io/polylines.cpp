#include "talweg/core/io/polylines.hpp"

#include <utility>

namespace talweg::formats {
namespace {

/// The marks of a line's points. The end of a closed one is a copy of its first point, and may say
/// what that does not.
std::vector<double> marks_along(const Line& line, bool closed, std::span<const double> marks) {
  std::vector<double> result;
  for (const std::uint32_t k : line) result.push_back(marks[k]);
  if (!closed) return result;
  if (result.front() == kNotSaid) result.front() = result.back();
  result.pop_back();
  return result;
}

}  // namespace

std::vector<CurveInput> curves_of(std::span<const Point> points, std::vector<Line> lines,
                                  std::span<const double> marks) {
  std::vector<CurveInput> curves;
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

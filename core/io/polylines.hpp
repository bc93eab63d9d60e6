// Polylines are made of lines between numbered points, joined end to end.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/drawing/joined_lines.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/io/curve_file.hpp"

namespace talweg::formats {

/// The value as an index below `count`; nothing if it is not one.
inline std::optional<std::uint32_t> index_below(double value, std::size_t count) {
  constexpr double kLimit = 4294967295.0;  // the largest 32-bit number marks an invalid index
  if (!(value >= 0 && value < kLimit && value < static_cast<double>(count))) return std::nullopt;
  if (value != std::floor(value)) return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

/// The joined lines as curves. Segments of two points are joined at equal positions, other lines at
/// equal indices of their ends. A curve is closed if it ends at its first index, or, with at least
/// four points, at equal coordinates. All indices must be in range. `marks` are the marks of the
/// points (point_marks.hpp), or empty.
std::vector<CurveInput> curves_of(std::span<const Point> points, std::vector<Line> lines,
                                  std::span<const double> marks = {});

/// Throws Error(kBadFile) unless there are as many marks as points and all numbers are marks.
/// `fail` throws the error with the file and the place.
template <class Fail>
void check_marks(std::span<const double> marks, std::size_t points, const Fail& fail) {
  if (marks.size() != points) {
    fail(fmt::format("expected one number exact for each of {} points, found {}", points,
                     marks.size()));
  }
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (is_mark(marks[k])) continue;
    fail(fmt::format(
        "exact of point {} is {:.17g}; expected a tolerance of 0 or more (a way-point), "
        "-1 (nothing is said) or -2 (painted)",
        k, marks[k]));
  }
}

}  // namespace talweg::formats

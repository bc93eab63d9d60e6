// Message numbers are positions, counts, lengths and bounds in the form in which messages show
// them.
#pragma once

#include <cstddef>
#include <string>

#include "talweg/core/space/point.hpp"

namespace talweg {

/// "(4200083.12, 500000.4, 0)": the coordinates to a thousandth of `edge` or finer, so that the
/// text tells neighbouring vertices apart, also far from the origin. Without zeros at the end, and
/// never more than 17 digits. `edge` is the length of an edge near `at`, mesh units; with 0 or a
/// number that is not finite, the text has all digits of the coordinates.
[[nodiscard]] std::string position_text(const Point& at, double edge);

/// "1,234,567". For counts only: ids of vertices and faces have no commas, as in files.
[[nodiscard]] std::string count_text(std::size_t count);

/// "4,821,040" or "12.34": a length >= 0 with `digits` significant digits (1 to 15), or with all
/// digits before the decimal point if these are more; below 1e-4, and from 1e15 on, with an
/// exponent.
[[nodiscard]] std::string length_text(double length, int digits);

/// "1 mesh unit" or "2.08 mesh units": length_text() with the unit.
[[nodiscard]] std::string mesh_units_text(double length, int digits = 3);

/// "at most 3 and at least 2": the bounds of a length, with six digits. A lower bound below a
/// millionth of `most`, such as a rounding error, is left out: "at most 3"; so is an infinite upper
/// bound: "at least 2".
[[nodiscard]] std::string bounds_text(double least, double most);

}  // namespace talweg

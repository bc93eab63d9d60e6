// A point mark is one number that says whether a curve's point was clicked or painted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// All functions here are O(points). The mark of a way-point is its tolerance in mesh units, 0 or
/// more. The other marks are the three negative numbers below.
constexpr double kNotSaid = -1;
constexpr double kPainted = -2;
constexpr double kControl = -3;  ///< see CurveInput::control_points; not in files

/// Whether a number is a mark that a file may have.
bool is_mark(double value);

/// The marks of a curve's points, one for each; empty if no point has a mark.
std::vector<double> marks_of(const CurveInput& curve);
/// Sets way-points and painted points from the marks. A curve must have as many points as marks.
void set_marks(CurveInput& curve, std::span<const double> marks);

/// The marks of a curve that was drawn through the given points, which it passes in this order. A
/// given point has the mark that comes with it; without marks, all given points are way-points.
/// Other points of the curve have kNotSaid.
std::vector<double> marks_through(const SurfaceCurve& drawn, std::span<const SurfacePoint> given,
                                  std::span<const double> marks = {});

/// The number of a curve's points.
std::size_t point_count(const CurveInput& curve);

}  // namespace talweg

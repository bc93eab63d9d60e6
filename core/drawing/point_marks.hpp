// A point mark is one number that says whether a curve's point was clicked or painted.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// All functions here are O(points). A mark of 0 or more is that of a way-point: its tolerance in
/// mesh units. There are three others.
constexpr double kNotSaid = -1;
constexpr double kPainted = -2;
constexpr double kControl = -3;  ///< see CurveInput::control_points; not in files

/// Whether a number is a mark that a file may have.
bool is_mark(double value);

/// The marks of a curve's points, one for each; empty if nothing is said of any.
std::vector<double> marks_of(const CurveInput& curve);
/// Sets way-points and painted points from the marks. A curve must have as many points as marks.
void set_marks(CurveInput& curve, std::span<const double> marks);

/// The marks of a curve that was drawn through given points, which it has in this order: those have
/// the marks given with them (without: they are way-points), and of the others nothing is said.
std::vector<double> marks_through(const SurfaceCurve& drawn, std::span<const SurfacePoint> given,
                                  std::span<const double> marks = {});

/// The number of a curve's points.
std::size_t point_count(const CurveInput& curve);

}  // namespace talweg

// A result report is filled with the measures of a drawing and its result.
#pragma once

#include <cmath>
#include <cstddef>

#include "talweg/core/measure/deviation_measure.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {

/// Reports numbers of points and measures of drawing and result, without the deviation. `edge` is
/// edge_length_near() of the drawing, `before` is measure_curve() of the drawing with this edge.
/// O(points · degree).
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const CurveMeasures& before, const SurfaceCurve& result);
/// Measures the drawing, too.
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const SurfaceCurve& result);

/// The report on a drawing without a result: the entries on the result have the values of the
/// drawing, and the deviations are infinite.
SmoothingReport report_on_nothing(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                  const CurveMeasures& measures);

/// The deviation between a result and its drawing; mesh units.
struct MeasuredDeviation {
  DeviationMeasure measure = DeviationMeasure::kNone;  ///< the measure used; never kAutomatic
  double to_drawn_max = HUGE_VAL;
  double to_drawn_mean = HUGE_VAL;
  double from_drawn_max = HUGE_VAL;
  double from_drawn_mean = HUGE_VAL;
  Point at = Point::Constant(HUGE_VAL);  ///< the point at the larger of both maxima
  bool exact = true;                     ///< if false, maxima and means are upper bounds
  double at_least = HUGE_VAL;            ///< lower bound of the larger maximum
  bool spared = false;  ///< not exact, because exact distances take far longer than smoothing
};

/// Measures the deviation, along the surface within the budget of `progress`. kAutomatic acts as
/// for tau < 1/8, with `edge_length_near` as the mean edge. `to_drawn` may be a distance that is
/// set to the drawing alone; if null, the meter uses its own. The deviation is infinite between
/// components of the mesh. Throws Cancelled (stage "measure").
MeasuredDeviation measure_deviation(DeviationMeasure measure, double edge_length_near,
                                    DeviationMeter& meter, const SurfaceMesh& mesh,
                                    const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    PolylineDistance* to_drawn = nullptr,
                                    const Progress& progress = {});

/// Stores a deviation in the report, with a warning if the deviation is infinite along the surface
/// or not exact. A deviation that is not exact sets the termination kLimit, unless `spared` is set.
void report_deviation(SmoothingReport& report, const MeasuredDeviation& measured);

/// The report on a curve that another method made from a drawing, with the measures of all reports:
/// points, lengths, curvatures, bending, edge length near the drawing and deviation. `potential`
/// and `engine` are "none", times are 0, and crossings are not counted. Throws Error(kBadCurve) if
/// two consecutive points of a curve share no face.
SmoothingReport report_on_result(const SurfaceMesh& mesh, DeviationMeter& meter,
                                 const SurfaceCurve& drawn, const SurfaceCurve& result,
                                 DeviationMeasure measure = DeviationMeasure::kAlongSurface);

constexpr double kFarInEdges = 3;  ///< mesh edges: a larger deviation gets a warning
/// Adds a warning if the exact deviation along the surface is larger than `far` (mesh units).
/// `automatic`: kAutomatic chose the measure, so a deviation through space means at least four mean
/// edges along the surface.
void warn_if_far(SmoothingReport& report, double far, bool automatic = false);

/// Reports the distance between this result and the last one, whose tau was about the same, and
/// warns of a jump. Distances are Euclidean. Throws Cancelled (stage "measure").
void report_move(SmoothingReport& report, const SurfaceMesh& mesh, double last_tau,
                 const SurfaceCurve& last, const SurfaceCurve& result,
                 const Progress& progress = {});

/// The number of surface faces at vertices that the triangulation has touched. O(touched).
std::size_t count_touched_faces(const SignpostTriangulation& triangulation);

}  // namespace talweg

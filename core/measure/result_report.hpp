// A report is filled with what is measured on a drawing and its result.
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

/// Reports points, lengths, curvatures and their spread before and after, but no deviation yet.
/// `edge` is edge_length_near() the drawing and `before` what measure_curve() gives for both.
/// O(points · degree).
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const CurveMeasures& before, const SurfaceCurve& result);
/// The same where the drawing is not measured yet.
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                const SurfaceCurve& result);

/// The report where there is no result: it has the drawing's values, both as before and as after.
SmoothingReport report_on_nothing(const SurfaceMesh& mesh, const SurfaceCurve& drawn, double edge,
                                  const CurveMeasures& measures);

/// How far a result and its drawing lie apart; mesh units.
struct MeasuredDeviation {
  DeviationMeasure measure = DeviationMeasure::kNone;  ///< as used; never kAutomatic
  double to_drawn_max = HUGE_VAL;
  double to_drawn_mean = HUGE_VAL;
  double from_drawn_max = HUGE_VAL;
  double from_drawn_mean = HUGE_VAL;
  Point at = Point::Constant(HUGE_VAL);  ///< the point with the larger of both maxima
  bool exact = true;                     ///< false: maxima and means are bounds
  double at_least = HUGE_VAL;            ///< the largest distance known
  bool spared = false;  ///< not exact since that would take far longer than smoothing
};

/// Measures the deviation; along the surface, as far as the budget of `progress` goes. kAutomatic
/// does what it does below tau = 1/8, with `edge_length_near` as the mean edge. `to_drawn` may be a
/// distance that is set to the drawing alone; if it is null, the meter uses its own. Where neither
/// curve reaches the other, the deviation is infinite. Throws Cancelled when `progress` (stage
/// "measure") says so.
MeasuredDeviation measure_deviation(DeviationMeasure measure, double edge_length_near,
                                    DeviationMeter& meter, const SurfaceMesh& mesh,
                                    const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    PolylineDistance* to_drawn = nullptr,
                                    const Progress& progress = {});

/// Stores it in the report, with a warning where it is infinite along the surface, and where it is
/// a bound: then the report says that a limit was reached, unless measuring was spared.
void report_deviation(SmoothingReport& report, const MeasuredDeviation& measured);

/// The report on a curve that another method made of a drawing. It is measured as our results are:
/// points, lengths, curvatures and their spread, the mesh's fineness near the drawing and the
/// deviation. `potential` and `engine` are "none", times are 0, and crossings are not counted.
/// Throws Error(kBadCurve) where two neighbours of a curve share no face.
SmoothingReport report_on_result(const SurfaceMesh& mesh, DeviationMeter& meter,
                                 const SurfaceCurve& drawn, const SurfaceCurve& result,
                                 DeviationMeasure measure = DeviationMeasure::kAlongSurface);

constexpr double kFarInEdges = 3;  ///< mesh edges: a larger deviation deserves a warning
/// Adds a sentence where result and drawing lie farther apart than this (mesh units) along the
/// surface. `automatic` tells that kAutomatic chose the measure: then a deviation through space
/// means that they lie at least four mean edges apart along the surface.
void warn_if_far(SmoothingReport& report, double far, bool automatic = false);

/// Reports how far the curve has moved since the last result, whose tau was about the same, and
/// warns of a jump. Distances are Euclidean. Throws Cancelled as report_deviation() does.
void report_move(SmoothingReport& report, const SurfaceMesh& mesh, double last_tau,
                 const SurfaceCurve& last, const SurfaceCurve& result,
                 const Progress& progress = {});

/// The number of surface faces with a corner whose directions have been laid out. O(touched).
std::size_t count_touched_faces(const SignpostTriangulation& triangulation);

}  // namespace talweg

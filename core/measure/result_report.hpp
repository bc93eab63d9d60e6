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

/// Points, lengths and curvatures before and after; no deviation yet. `before` are the measures of
/// the drawing. O(points · degree).
SmoothingReport report_on_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                const CurveMeasures& before, const SurfaceCurve& result);

/// The report where there is no result: what is known of the drawing, before and after.
SmoothingReport report_on_nothing(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                                  const CurveMeasures& measures);

/// How far a result and its drawing lie apart; mesh units.
struct MeasuredDeviation {
  DeviationMeasure measure = DeviationMeasure::kNone;  ///< by what; never kAutomatic
  double to_drawn_max = HUGE_VAL;
  double to_drawn_mean = HUGE_VAL;
  double from_drawn_max = HUGE_VAL;
  double from_drawn_mean = HUGE_VAL;
  Point at = Point::Constant(HUGE_VAL);  ///< where the larger of both maxima is
};

/// Measures it; kAutomatic as below tau = 1/8, with the mesh's edges near the drawing that long.
/// `to_drawn` may be a distance that is set to the drawing alone; null: the meter has one of its
/// own. Where neither reaches the other the deviation is infinite. Throws Cancelled when `progress`
/// (stage "measure") says so.
MeasuredDeviation measure_deviation(DeviationMeasure measure, double edge_length_near,
                                    DeviationMeter& meter, const SurfaceMesh& mesh,
                                    const SurfaceCurve& drawn, const SurfaceCurve& result,
                                    PolylineDistance* to_drawn = nullptr,
                                    const Progress& progress = {});

/// Puts it into the report, with a warning where it is infinite along the surface.
void report_deviation(SmoothingReport& report, const MeasuredDeviation& measured);

/// The report on a curve that some other method made of a drawing, measured as ours are: points,
/// lengths, curvatures, the mesh's fineness near the drawing and the deviation. `potential` and
/// `engine` are "none", times are 0, and nothing is said about crossings.
/// Throws Error(kBadCurve) where two neighbours of a curve share no face.
SmoothingReport report_on_result(const SurfaceMesh& mesh, DeviationMeter& meter,
                                 const SurfaceCurve& drawn, const SurfaceCurve& result,
                                 DeviationMeasure measure = DeviationMeasure::kAlongSurface);

constexpr double kFarInEdges = 3;  ///< mesh edges: a deviation that is worth a warning
/// Adds a sentence where result and drawing lie farther apart than this (mesh units) along the
/// surface; of what kAutomatic measured through space that is known where `automatic` is set.
void warn_if_far(SmoothingReport& report, double far, bool automatic = false);

/// Adds how far the curve has moved since the last result, whose tau was about the same, and names
/// a jump. Distances are Euclidean. Throws Cancelled as report_deviation() does.
void report_move(SmoothingReport& report, const SurfaceMesh& mesh, double last_tau,
                 const SurfaceCurve& last, const SurfaceCurve& result,
                 const Progress& progress = {});

/// Faces of the surface with a corner whose directions have been laid out. O(touched).
std::size_t count_touched_faces(const SignpostTriangulation& triangulation);

}  // namespace talweg

// A cleaned drawing has the given curves without rests and hooks of the hand and without double
// clicks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A cleaned curve.
struct CleanedCurve {
  SurfaceCurve curve;
  StrokeSlack slack;
  /// Per point, its place on the given curve, as in CleanedStroke; empty if the curve is unchanged.
  std::vector<double> places;
  std::size_t left_out = 0;  ///< number of given points that were left out
  double farthest = 0;       ///< mesh units: largest distance of a point left out from the curve
  CurveMeasures measures;    ///< of the given curve, if it was changed
  std::vector<std::string> notes;  ///< sentences for the user about rests, hooks, clicks

  /// Interpolates values at the given points linearly at the points of `curve`.
  [[nodiscard]] std::vector<double> values(std::span<const double> given, bool closed) const;
};

struct CleanedDrawing {
  std::vector<CleanedCurve> curves;
  std::vector<SurfacePoint> painted;  ///< painted points on the cleaned curves
  std::vector<WayPoint> way_points;   ///< way-points without merged ones

  [[nodiscard]] std::vector<SurfaceCurve> drawn() const;
  [[nodiscard]] std::vector<StrokeSlack> slacks() const;
};

/// Whether two cleanings of the same given curves keep the same points and report the same.
bool is_same(const CleanedDrawing& a, const CleanedDrawing& b);

/// Adds the cleaning of a curve to its report: warnings, points left out, and the measures of the
/// given curve, whose turns are those on the smooth ground if there is one.
void report_cleaning(const CleanedCurve& curve, const SurfaceCurve& given,
                     const SurfaceMesh* ground, SmoothingReport& report);

/// Estimates the slack of the strokes of each curve (stroke_slack.hpp) and removes rests, hooks and
/// redundant points of strokes (stroke_cleaning.hpp). Way-points within click_distance of each
/// other are merged. Pins, corners, other way-points and legs stay; for the paper's method, all
/// points stay. The result does not depend on the direction of a curve or on the first point of a
/// loop. `known`: slacks that are not estimated again, one per curve, or empty. The curves must
/// pass check_drawn(). Throws Error(kBadCurve) for a curve without length, Cancelled. O(points),
/// and an estimate per curve.
CleanedDrawing cleaned_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> given,
                               const CurveOptions& options, std::span<const StrokeSlack> known,
                               const Progress& progress);

}  // namespace talweg

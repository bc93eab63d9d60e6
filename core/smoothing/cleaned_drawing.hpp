// A cleaned drawing is what is smoothed of the curves that were given.
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

/// One of its curves.
struct CleanedCurve {
  SurfaceCurve curve;
  StrokeSlack slack;
  /// Per point where it was on the given curve, as in CleanedStroke; empty if that is as it was.
  std::vector<double> places;
  std::size_t left_out = 0;       ///< how many of the given points
  double farthest = 0;            ///< mesh units: from what is left
  CurveMeasures measures;         ///< of the given curve, unless it is as it was
  std::vector<std::string> told;  ///< sentences for the user: on rests, hooks, clicks

  /// Values at the given points, linear in between, at the points of `curve`.
  [[nodiscard]] std::vector<double> values(std::span<const double> given, bool closed) const;
};

struct CleanedDrawing {
  std::vector<CleanedCurve> curves;
  std::vector<SurfacePoint> painted;  ///< of the options, on the cleaned curves
  std::vector<WayPoint> way_points;   ///< of the options, without those that are one with others

  [[nodiscard]] std::vector<SurfaceCurve> drawn() const;
  [[nodiscard]] std::vector<StrokeSlack> slacks() const;
};

/// Whether the same is smoothed, and told, of the same given curves.
bool is_same(const CleanedDrawing& a, const CleanedDrawing& b);

/// What the report on a curve says of what was given.
void report_cleaning(const CleanedCurve& curve, const SurfaceCurve& given, SmoothingReport& report);

/// Estimates how exact the strokes of each curve are (stroke_slack.hpp) and leaves out of them what
/// lies within a part of that (stroke_cleaning.hpp). Way-points that lie beside each other become
/// one. Pins, corners, way-points and legs stay; for
/// the paper's method, everything does. What comes out does not depend on the direction in which a
/// curve was drawn, or on where a loop begins. Slacks that are known are
/// not estimated anew. The curves must pass check_drawn(). Throws
/// Error(kBadCurve) for a curve without length, Cancelled. O(points), and an estimate per curve.
CleanedDrawing cleaned_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> given,
                               const CurveOptions& options, std::span<const StrokeSlack> known,
                               const Progress& progress);

}  // namespace talweg

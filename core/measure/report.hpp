// A report says how a result came about and how far it lies from its drawing.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/measure/deviation_measure.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Milliseconds. `open` depends on the mesh only, `solve` on the drawing; the others recur for each
/// new tau.
struct StageTimes {
  double load = 0;        ///< reading files; 0 where there are none
  double open = 0;        ///< checks, connectivity, factors
  double solve = 0;       ///< embedding and distance
  double straighten = 0;  ///< lifting and FlipOut
  double trace = 0;       ///< tracing back to points on the mesh
  double relax = 0;       ///< the paper's relaxation
  double fair = 0;        ///< fairing
  double measure = 0;     ///< the report's own measures, mostly the deviation
  double total = 0;       ///< the sum of the above
};

/// Which potential held a curve.
enum class PotentialKind {
  kPaper,     ///< equations 4 to 6 of the paper
  kCorridor,  ///< flat within the slack
  kCustom,    ///< given by the caller
  kNone,      ///< another method made the curve
};

/// Where a curve was smoothed.
enum class Engine {
  kFull,     ///< on the mesh, by a distance over all of it
  kLocal,    ///< on the mesh, by a distance near the drawing only
  kRefined,  ///< on faces that were divided along the drawing
  kPreview,  ///< like kLocal, while a part of the drawing is being dragged
  kNone,     ///< another method made the curve
};

/// How the smoothing of a curve ended, from best to worst.
enum class Outcome {
  kConverged,
  kMissed,     ///< it misses a point that it was to pass
  kDeviation,  ///< no curve within the bound was found
  kCollapsed,  ///< the loop shrank below the floor; it is returned as it was at that moment
  kLimit,      ///< a bound on the work was reached, or a budget used up
  kCancelled,  ///< the caller cancelled it
};

/// What a curve's slack is made of.
enum class SlackSource {
  kNone,       ///< there is none
  kGiven,      ///< the caller's
  kEdges,      ///< the segments of a drawing along edges of the mesh
  kTrembling,  ///< the width of the hand's trembling
  kSegments,   ///< the segments of a drawing in which no trembling stands out
};

/// What lies farthest from the other.
enum class FarthestOf {
  kNothing,  ///< nothing was measured
  kResult,   ///< a point of the result, from the drawing
  kDrawing,  ///< a point of the drawing, from the result: a part that was cut off
  kPoint,    ///< a point that the result was to pass, and misses
};

/// The names used in reports; those of DeviationMeasure are "surface", "euclidean" and "none".
const char* to_string(PotentialKind potential);
const char* to_string(Engine engine);
const char* to_string(Outcome outcome);
const char* to_string(SlackSource source);
const char* to_string(DeviationMeasure measure);
const char* to_string(FarthestOf of);

/// A warning by which a result may be of no use.
struct Decisive {
  std::string sentence;
  Point at = Point::Constant(HUGE_VAL);  ///< the place that it is about; infinite where it has none
  bool operator==(const Decisive& other) const = default;
};

/// The report on one curve, or the totals of a set. In totals, counts, lengths, total curvatures
/// and bendings are sums, maxima are maxima, means are weighted by length, `termination` is the
/// worst, `deviation` is kEuclidean if any curve's is, and exact if all are. Lengths are in mesh
/// units, angles in radians. Deviations are infinite if they were not measured, or if the curves
/// lie on parts of the mesh that are not connected. "Before" and "drawn" mean the curve as it was
/// given, before corners were capped. The entries of `before` and `after` are named
/// `length_before`, `length_after` and so on, those of total_curvature `curvature_...` and those of
/// max_curvature `curvature_max_...`; signed_curvature and max_at have none, and in totals max_at
/// means nothing. `decisive` are the sentences, and `decisive_at` x, y and z of their places, one
/// after the other.
struct SmoothingReport {
  std::string version;       ///< of the library
  std::size_t faces = 0;     ///< of the mesh
  std::size_t vertices = 0;  ///< of the mesh
  double tau = 0;            ///< as requested
  double slack = 0;          ///< mesh units; 0 for the paper's method
  SlackSource slack_from = SlackSource::kNone;
  std::size_t left_out = 0;         ///< points of the drawing that say nothing beside others
  double left_out_max = 0;          ///< mesh units: how far these lie from what was smoothed
  double max_deviation = HUGE_VAL;  ///< mesh units: the bound of smooth_within(), if any
  std::size_t pins_added = 0;       ///< by smooth_within()
  double edge_length_near = 0;      ///< mesh units: mean edge within two rings of the drawing
  /// edge_length_near: how rough the mesh is along the drawing. Where it is above 0.04, turns and
  /// bending are those on the surface without that roughness. HUGE_VAL where nobody has looked.
  double roughness_near = HUGE_VAL;
  PotentialKind potential = PotentialKind::kNone;
  Engine engine = Engine::kNone;
  bool closed = false;              ///< the first point is not repeated, and counts once
  std::size_t points_before = 0;    ///< as drawn
  std::size_t points_after = 0;     ///< of the result
  CurveMeasures before, after;      ///< both with edge_length_near, that near the drawing
  double lifted_length_before = 0;  ///< after capping, before straightening
  double lifted_length_after = 0;   ///< after straightening, before relaxation
  DeviationMeasure deviation = DeviationMeasure::kNone;  ///< which distance is below
  double deviation_to_drawn_max = 0;     ///< mesh units: of the result to the drawing
  double deviation_to_drawn_mean = 0;    ///< mesh units
  double deviation_from_drawn_max = 0;   ///< mesh units: of the drawing to the result
  double deviation_from_drawn_mean = 0;  ///< mesh units
  Point deviation_at = Point::Zero();    ///< the point with the larger of both maxima
  bool deviation_exact = true;    ///< false: measuring ended early, and the above are upper bounds
  double deviation_at_least = 0;  ///< mesh units: the largest distance known to be there
  std::size_t missed_points = 0;  ///< that the result was to pass
  double missed_max = 0;          ///< mesh units, through space: of these to the result
  Point missed_at = Point::Zero();  ///< the one that lies farthest from it
  double moved = HUGE_VAL;     ///< mesh units: from the last result, if its tau differs by <= 5 %
  std::size_t flips = 0;       ///< of the whole run
  std::size_t iterations = 0;  ///< cleared wedges, of the whole run
  std::size_t faces_touched = 0;    ///< mesh faces that the whole run touched
  std::size_t trace_fallbacks = 0;  ///< crossings that the tracing put at the end of their edge
  /// 0. Fair curves used to start from the straightened curve but for these parts of the drawing.
  std::size_t stretches_redrawn = 0;
  double mollification = 0;  ///< mesh units: largest lengthening of an edge for the heat distance
  std::size_t crossings_before = 0;  ///< of the drawing with itself and later curves of the set
  std::size_t crossings_after = 0;   ///< of the result, counted likewise
  Outcome termination = Outcome::kConverged;
  std::vector<std::string> warnings;  ///< sentences for the user
  std::vector<Decisive> decisive;     ///< those of them by which the result may be of no use
  StageTimes time_ms;                 ///< milliseconds
  double peak_memory_mib = 0;         ///< of the process so far, MiB
};

/// Adds a warning that is decisive.
void warn_decisively(SmoothingReport& report, Decisive warning);
/// Says first that sentences, which the warnings have already, are decisive.
void lead_with(SmoothingReport& report, const std::vector<std::string>& sentences);

/// How far a result and its drawing lie apart, whichever of them has the point that is farther.
struct Farthest {
  double at_least = HUGE_VAL;  ///< mesh units; infinite where nothing was measured, or not reached
  /// Mesh units: the same where the distance is exact, and infinite where it is measured through
  /// space, since along the surface it may be any more.
  double at_most = HUGE_VAL;
  Point at = Point::Constant(HUGE_VAL);
  FarthestOf of = FarthestOf::kNothing;
};
/// The one number for people. It is the larger of both deviations, or how far off a point is that
/// the result was to pass. Its entries are named `farthest` (at_least), `farthest_at_most`,
/// `farthest_at` and `farthest_of`.
Farthest farthest(const SmoothingReport& report);

/// Sums up the reports on the curves of one run.
SmoothingReport total_of(const std::vector<SmoothingReport>& reports);

/// What a report has, under the names above and in their order.
std::vector<ReportEntry> entries_of(const SmoothingReport& report);

/// JSON with the names of the entries; non-finite numbers become null.
std::string to_json(const SmoothingReport& report);
/// For one curve its report; for several the totals, with an array `curves` of the single reports.
std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves);

/// The largest amount of memory the process has used so far; 0 where the system does not tell.
double peak_memory_mib();

}  // namespace talweg

// A report describes the smoothing of a curve, and the deviation of the result from its drawing.
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

/// Times in milliseconds. `open` depends on the mesh only, `solve` on the drawing; the later stages
/// recur for each new tau.
struct StageTimes {
  double load = 0;        ///< reading files, if any
  double open = 0;        ///< checks, connectivity, factors
  double solve = 0;       ///< embedding and distance
  double straighten = 0;  ///< lifting and FlipOut
  double trace = 0;       ///< tracing back to points on the mesh
  double relax = 0;       ///< the paper's relaxation
  double fair = 0;        ///< fairing
  double measure = 0;     ///< measures of the report, mostly the deviation
  double total = 0;       ///< the sum of all stages
};

/// The potential that held a curve near its drawing.
enum class PotentialKind {
  kPaper,     ///< equations 4 to 6 of the paper
  kCorridor,  ///< flat within the slack
  kCustom,    ///< given by the caller
  kNone,      ///< another method made the curve
};

/// The mesh and the distance that a curve was smoothed with.
enum class Engine {
  kFull,     ///< the given mesh, with a distance over the whole mesh
  kLocal,    ///< the given mesh, with a distance near the drawing only
  kRefined,  ///< a mesh whose faces are divided along the drawing
  kPreview,  ///< like kLocal, while a part of the drawing is dragged
  kNone,     ///< another method made the curve
};

/// The outcome of smoothing a curve, from best to worst.
enum class Outcome {
  kConverged,
  kMissed,     ///< the result misses a point that it should pass
  kDeviation,  ///< no curve within the bound on deviation was found
  kCollapsed,  ///< the loop shrank below the length floor; the result is the loop at that moment
  kLimit,      ///< a bound on the work was reached, or the budget was used up
  kCancelled,  ///< the caller cancelled the smoothing
};

/// The source of a curve's slack.
enum class SlackSource {
  kNone,       ///< no slack
  kGiven,      ///< given by the caller
  kEdges,      ///< the segment lengths of a drawing along mesh edges
  kTrembling,  ///< the estimated width of the hand's trembling
  kSegments,   ///< the segment lengths of a drawing without detectable trembling
};

/// The kind of the farthest point.
enum class FarthestOf {
  kNothing,  ///< nothing was measured
  kResult,   ///< a point of the result, from the drawing
  kDrawing,  ///< a point of the drawing, from the result: the result cuts off a part
  kPoint,    ///< a point that the result should pass
};

/// The names in reports. DeviationMeasure has "surface", "euclidean", "none" and "automatic".
const char* to_string(PotentialKind potential);
const char* to_string(Engine engine);
const char* to_string(Outcome outcome);
const char* to_string(SlackSource source);
const char* to_string(DeviationMeasure measure);
const char* to_string(FarthestOf of);

/// A warning of such weight that the result may be useless.
struct Decisive {
  std::string sentence;
  Point at = Point::Constant(HUGE_VAL);  ///< its place; infinite without a place
  bool operator==(const Decisive& other) const = default;
};

/// The report on one curve, or the totals of a set. In totals, counts and lifted lengths are sums,
/// measures are sums or maxima (named_measures.hpp), other maxima are maxima, means are weighted by
/// length, `termination` is the worst, `deviation` is kEuclidean if any curve has kEuclidean, and
/// `deviation_exact` holds if it holds for all curves. Lengths are in mesh units, angles in
/// radians. Deviations are infinite if they were not measured, or if the curves lie on different
/// components of the mesh. "Before" and "drawn" refer to the given curve, before corners were
/// capped. Entries in JSON have the names of the fields, with these exceptions: the entries of
/// `before` and `after` are the names of kNamedMeasures with `_before` and `_after`, so
/// signed_curvature and max_at have none. In totals max_at has no meaning. The entry `decisive`
/// lists the sentences, `decisive_at` the x, y and z of their places.
struct SmoothingReport {
  std::string version;       ///< of the library
  std::size_t faces = 0;     ///< of the mesh
  std::size_t vertices = 0;  ///< of the mesh
  double tau = 0;            ///< as requested
  double slack = 0;          ///< mesh units; 0 for the paper's method
  SlackSource slack_from = SlackSource::kNone;
  std::size_t left_out = 0;         ///< redundant points of the drawing, left out
  double left_out_max = 0;          ///< mesh units: their largest distance to the smoothed drawing
  double max_deviation = HUGE_VAL;  ///< mesh units: the bound of smooth_within(), if any
  std::size_t pins_added = 0;       ///< by smooth_within()
  double edge_length_near = 0;      ///< mesh units: mean edge within two rings of the drawing
  /// In units of edge_length_near: the roughness of the mesh along the drawing (roughness_along()).
  /// Above 0.04, turns and bending are measured on the surface without roughness (smooth_ground()).
  /// HUGE_VAL if not measured.
  double roughness_near = HUGE_VAL;
  PotentialKind potential = PotentialKind::kNone;
  Engine engine = Engine::kNone;
  bool closed = false;              ///< a closed curve does not repeat its first point
  std::size_t points_before = 0;    ///< of the drawing
  std::size_t points_after = 0;     ///< of the result
  CurveMeasures before, after;      ///< both with h = edge_length_near
  double lifted_length_before = 0;  ///< after capping, before straightening
  double lifted_length_after = 0;   ///< after straightening, before relaxation
  DeviationMeasure deviation = DeviationMeasure::kNone;  ///< kind of the distances below
  double deviation_to_drawn_max = 0;     ///< mesh units: from the result to the drawing
  double deviation_to_drawn_mean = 0;    ///< mesh units
  double deviation_from_drawn_max = 0;   ///< mesh units: from the drawing to the result
  double deviation_from_drawn_mean = 0;  ///< mesh units
  Point deviation_at = Point::Zero();    ///< the point at the larger maximum
  bool deviation_exact = true;           ///< if false, the deviations are upper bounds
  double deviation_at_least = 0;         ///< mesh units: lower bound of the larger maximum
  std::size_t missed_points = 0;         ///< points that the result should pass and misses
  double missed_max = 0;            ///< mesh units, through space: from these points to the result
  Point missed_at = Point::Zero();  ///< the missed point farthest from the result
  double moved = HUGE_VAL;          ///< mesh units: from the last result, if tau changed by <= 5 %
  std::size_t flips = 0;            ///< of the whole run
  std::size_t iterations = 0;       ///< wedges that FlipOut cleared, of the whole run
  std::size_t faces_touched = 0;    ///< mesh faces that the whole run touched
  std::size_t trace_fallbacks = 0;  ///< crossings that tracing moved to the end of an edge
  /// Always 0; kept because readers of reports may expect the entry.
  std::size_t stretches_redrawn = 0;
  double mollification = 0;  ///< mesh units: largest lengthening of an edge for the heat distance
  std::size_t crossings_before =
      0;                            ///< of the drawing with itself and with later curves of the set
  std::size_t crossings_after = 0;  ///< of the result, counted in the same way
  Outcome termination = Outcome::kConverged;
  std::vector<std::string> warnings;  ///< sentences for the user
  std::vector<Decisive> decisive;     ///< warnings that the result may be useless
  StageTimes time_ms;                 ///< milliseconds
  double peak_memory_mib = 0;         ///< MiB, largest use of the process so far
};

/// Adds a decisive warning to `warnings` and `decisive`.
void warn_decisively(SmoothingReport& report, Decisive warning);
/// Inserts sentences, which must be among the warnings, at the front of `decisive`.
void lead_with(SmoothingReport& report, const std::vector<std::string>& sentences);

/// The largest distance between a result and its drawing, in either direction.
struct Farthest {
  double at_least = HUGE_VAL;  ///< mesh units; infinite if not measured or not connected
  /// Mesh units: equal to at_least if the distance is exact and no point is missed; infinite if the
  /// distance, or that of a missed point, was measured through space, because the distance along
  /// the surface may be arbitrarily longer.
  double at_most = HUGE_VAL;
  Point at = Point::Constant(HUGE_VAL);
  FarthestOf of = FarthestOf::kNothing;
};
/// The larger of both deviations, or the distance to a missed point if it is larger: one number for
/// people. In JSON the entries are `farthest` (at_least), `farthest_at_most`, `farthest_at` and
/// `farthest_of`.
Farthest farthest(const SmoothingReport& report);

/// The totals of the reports on the curves of one run.
SmoothingReport total_of(const std::vector<SmoothingReport>& reports);

/// The entries of a report, in the order of the fields.
std::vector<ReportEntry> entries_of(const SmoothingReport& report);

/// A report as JSON; numbers that are not finite become null.
std::string to_json(const SmoothingReport& report);
/// The totals as JSON; for several curves with an array `curves` of their reports.
std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves);

/// The largest memory use of the process so far, MiB; 0 if the system does not report it.
double peak_memory_mib();

}  // namespace talweg

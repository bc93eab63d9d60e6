// What every result says about itself.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// Milliseconds. `open` depends on the mesh only, `solve` on the drawing; the rest is what a new
/// tau repeats.
struct StageTimes {
  double load = 0;        ///< reading files; 0 where there are none
  double open = 0;        ///< checks, connectivity, factors
  double solve = 0;       ///< embedding and distance
  double straighten = 0;  ///< lift and FlipOut
  double trace = 0;       ///< back to points on the mesh
  double relax = 0;       ///< the paper's relaxation
  double polish = 0;      ///< the corridor's
  double total = 0;       ///< the sum of the above
};

/// The report on one curve, or the totals of a set: there counts, lengths and total curvatures are
/// sums, maxima are maxima, means are weighted by length, `termination` is the worst, and
/// `deviation` is "euclidean" where one of them is.
/// Lengths in mesh units, angles in radians; deviations that were not measured, or between curves
/// on parts of the mesh that are not connected, are infinite. "Before" and "drawn" mean the curve
/// as it was given, before corners were capped.
struct SmoothingReport {
  std::string version;                   ///< of the library
  std::size_t faces = 0;                 ///< of the mesh
  std::size_t vertices = 0;              ///< of the mesh
  double tau = 0;                        ///< as asked for
  double slack = 0;                      ///< mesh units; 0 for the paper's method
  double max_deviation = HUGE_VAL;       ///< mesh units, as asked of smooth_within(), or none
  std::size_t pins_added = 0;            ///< by smooth_within()
  double edge_length_near = 0;           ///< mesh units: mean edge within two rings of the drawing
  std::string potential;                 ///< "paper", "corridor" or "custom"
  std::string engine;                    ///< "full", "local", "refined" or "preview"
  bool closed = false;                   ///< the first point is not repeated, and counts once
  std::size_t points_before = 0;         ///< as drawn
  std::size_t points_after = 0;          ///< of the result
  double length_before = 0;              ///< mesh units
  double length_after = 0;               ///< mesh units
  double lifted_length_before = 0;       ///< after capping, before straightening
  double lifted_length_after = 0;        ///< after straightening, before relaxation
  double curvature_before = 0;           ///< radians: sum of the turning angles
  double curvature_after = 0;            ///< radians
  double curvature_max_before = 0;       ///< radians: the largest turn at one point
  double curvature_max_after = 0;        ///< radians
  std::string deviation;                 ///< "surface", "euclidean" or "none": the distance below
  double deviation_to_drawn_max = 0;     ///< mesh units: of the result to the drawing
  double deviation_to_drawn_mean = 0;    ///< mesh units
  double deviation_from_drawn_max = 0;   ///< mesh units: of the drawing to the result
  double deviation_from_drawn_mean = 0;  ///< mesh units
  Point deviation_at = Point::Zero();    ///< where the larger of both is
  double moved = HUGE_VAL;  ///< mesh units: against the last result, if its tau differs by <= 5 %
  std::size_t flips = 0;    ///< of the whole run
  std::size_t iterations = 0;        ///< cleared wedges of the whole run
  std::size_t faces_touched = 0;     ///< of the mesh, by the whole run
  std::size_t trace_fallbacks = 0;   ///< crossings put at the end of their edge
  double mollification = 0;          ///< mesh units: most that an edge was lengthened for the heat
  std::size_t crossings_before = 0;  ///< of the drawing with itself and later curves of the set
  std::size_t crossings_after = 0;   ///< of the result, counted likewise
  std::string termination;  ///< "converged", "deviation", "collapsed", "limit" or "cancelled"
  std::vector<std::string> warnings;  ///< sentences for the user
  StageTimes time_ms;                 ///< milliseconds
  double peak_memory_mib = 0;         ///< of the process so far, MiB
};

/// Sums up the reports on the curves of one run.
SmoothingReport total_of(const std::vector<SmoothingReport>& reports);

/// One named value of a report. A dot in a key says that it belongs to a group ("time_ms.trace").
struct ReportEntry {
  std::string key;
  std::variant<double, std::uint64_t, bool, std::string, std::vector<double>,
               std::vector<std::string>>
      value;
};
/// All of a report, under the field names above and in their order.
std::vector<ReportEntry> entries_of(const SmoothingReport& report);

/// JSON with the field names above; non-finite numbers become null.
std::string to_json(const SmoothingReport& report);
/// One curve: its report. Several: the totals, and an array `curves` of the single reports.
std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves);

/// The same from entries, of this library or of a plugin: `curves` is left out for fewer than two.
std::string to_json(const std::vector<ReportEntry>& total,
                    const std::vector<std::vector<ReportEntry>>& curves);

/// The most memory the process has used so far; 0 where the system does not tell.
double peak_memory_mib();

}  // namespace talweg

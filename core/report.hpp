// What every result says about itself.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "talweg/core/mesh_lists.hpp"

namespace talweg {

/// Milliseconds. `open` depends on the mesh only, `solve` on the drawing; the rest is what a new
/// tau repeats.
struct StageTimes {
  double load = 0;
  double open = 0;
  double solve = 0;
  double straighten = 0;
  double trace = 0;
  double relax = 0;
  double polish = 0;
  double total = 0;
};

/// The report on one curve, or the totals of a set: there counts, lengths and total curvatures are
/// sums, maxima are maxima, means are weighted by length, and `termination` is the worst.
/// Lengths in mesh units, angles in radians. "Before" and "drawn" mean the curve as it was given,
/// before corners were capped.
struct SmoothingReport {
  std::string version;
  std::size_t faces = 0;
  std::size_t vertices = 0;
  double tau = 0;
  double slack = 0;
  std::string potential;
  std::string engine;
  bool closed = false;
  std::size_t points_before = 0;
  std::size_t points_after = 0;
  double length_before = 0;
  double length_after = 0;
  double lifted_length_before = 0;  ///< after capping, before straightening
  double lifted_length_after = 0;   ///< after straightening, before relaxation
  double curvature_before = 0;
  double curvature_after = 0;
  double curvature_max_before = 0;
  double curvature_max_after = 0;
  double deviation_to_drawn_max = 0;
  double deviation_to_drawn_mean = 0;
  double deviation_from_drawn_max = 0;
  double deviation_from_drawn_mean = 0;
  Point deviation_at = Point::Zero();
  std::size_t flips = 0;
  std::size_t iterations = 0;
  std::size_t faces_touched = 0;
  std::size_t trace_fallbacks = 0;
  std::string termination;
  std::vector<std::string> warnings;
  StageTimes time_ms;
  double peak_memory_mib = 0;
};

/// Sums up the reports on the curves of one run.
SmoothingReport total_of(const std::vector<SmoothingReport>& reports);

/// JSON with the field names above; non-finite numbers become null.
std::string to_json(const SmoothingReport& report);
/// One curve: its report. Several: the totals, and an array `curves` of the single reports.
std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves);

/// The most memory the process has used so far; 0 where the system does not tell.
double peak_memory_mib();

}  // namespace talweg

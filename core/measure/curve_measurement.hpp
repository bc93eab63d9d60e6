// A curve measurement is what curves on a mesh measure, and how far they lie from others.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct CurveMeasurementOptions {
  /// Mesh units: the windows in which turning is measured; default: edge_length_near() each curve.
  std::optional<double> edge;

  void validate() const;  ///< throws Error(kBadUsage)
};

/// The measures of one curve, or the totals of several: counts, lengths, curvatures and
/// bendings are sums, turns are maxima, the edge length is the mean, and contacts between curves
/// are included.
struct MeasuredCurve {
  std::size_t points = 0;
  bool closed = false;
  CurveMeasures measures;
  double edge = 0;               ///< mesh units: what its windows are compared with
  Point max_at = Point::Zero();  ///< the place of the largest turn
  std::vector<Point> contacts;   ///< the beginnings of self-contacts
  std::size_t stretches = 0;     ///< number of self-contacts that are more than a point
};

struct MeasuredCurves {
  std::vector<MeasuredCurve> each;
  MeasuredCurve total;
};

/// How far curves lie from others, along the surface, mesh units; infinite between parts that are
/// not connected.
struct MeasuredDistance {
  double to_max = 0, to_mean = 0;      ///< of the curve's points to the other
  double from_max = 0, from_mean = 0;  ///< of the other's points to the curve
  Point at = Point::Zero();            ///< the point with the larger maximum
};

struct CurveMeasurement {
  std::size_t faces = 0, vertices = 0;  ///< of the mesh
  MeasuredCurves curves;
  std::optional<MeasuredCurves> others;
  std::vector<MeasuredDistance> deviations;  ///< of pairs; empty if the counts differ
  MeasuredDistance deviation;                ///< of all curves
  std::vector<std::string> warnings;
};

/// Measures the curves, and their deviation from the others unless there are none: as many are
/// compared one by one in their order, more or fewer all together. Throws Error(kBadUsage) for bad
/// options, Error(kBadCurve) where there is no curve, one has no points, or two neighbours share no
/// face; Cancelled when `progress` (stage "measure") says so. O(n log n) for n points, and what
/// self_contacts() and DeviationMeter cost, for each curve and for all together.
CurveMeasurement measure_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfaceCurve> others = {},
                                const CurveMeasurementOptions& options = {},
                                const Progress& progress = {});

/// The report: what all curves measure together, and those they are compared with.
std::vector<ReportEntry> entries_of(const CurveMeasurement& measurement);
/// The same for each curve.
std::vector<std::vector<ReportEntry>> curve_entries_of(const CurveMeasurement& measurement);

}  // namespace talweg

// A curve measurement contains the measures of curves on a mesh, and their deviation from other
// curves.
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
  /// Mesh units, > 0: the edge length h of CurveMeasures; default: edge_length_near() of each
  /// curve.
  std::optional<double> edge;

  void validate() const;  ///< throws Error(kBadUsage)
};

/// The measures of one curve, or the totals of several. In totals, counts are sums, measures are
/// sums or maxima (named_measures.hpp), the edge length is the mean, and contacts between curves
/// are included.
struct MeasuredCurve {
  std::size_t points = 0;
  bool closed = false;
  CurveMeasures measures;
  double edge = 0;               ///< mesh units: h of CurveMeasures
  Point max_at = Point::Zero();  ///< the position of the largest turn
  std::vector<Point> contacts;   ///< the positions where self-contacts begin
  std::size_t stretches = 0;     ///< number of self-contacts longer than a point
};

struct MeasuredCurves {
  std::vector<MeasuredCurve> each;
  MeasuredCurve total;
};

/// The deviation between curves along the surface, mesh units; infinite between components of the
/// mesh.
struct MeasuredDistance {
  double to_max = 0, to_mean = 0;      ///< distances of the curve's points to the other curve
  double from_max = 0, from_mean = 0;  ///< distances of the other's points to the curve
  Point at = Point::Zero();            ///< the point at the larger maximum
};

struct CurveMeasurement {
  std::size_t faces = 0, vertices = 0;  ///< of the mesh
  MeasuredCurves curves;
  std::optional<MeasuredCurves> others;
  std::vector<MeasuredDistance> deviations;  ///< of pairs of curves; empty if the counts differ
  MeasuredDistance deviation;                ///< of all curves
  std::vector<std::string> warnings;
};

/// Measures curves, and their deviation from other curves if there are any. If both lists have
/// equal sizes, curves are compared in pairs, else as two sets. Throws Error(kBadUsage) for bad
/// options; Error(kBadCurve) if there is no curve, a curve has no points, or two consecutive points
/// share no face; Cancelled (stage "measure"). O(n log n) for n points, plus the costs of
/// self_contacts() and DeviationMeter, for each curve and for all together.
CurveMeasurement measure_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfaceCurve> others = {},
                                const CurveMeasurementOptions& options = {},
                                const Progress& progress = {});

/// The report's totals: of all curves, and of the curves that they are compared with.
std::vector<ReportEntry> entries_of(const CurveMeasurement& measurement);
/// The report's entries of each curve.
std::vector<std::vector<ReportEntry>> curve_entries_of(const CurveMeasurement& measurement);

}  // namespace talweg

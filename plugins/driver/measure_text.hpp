// The measure text is what `talweg measure` tells, as a table or as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::driver {

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

/// Measured along the surface, mesh units; infinite between parts that are not connected.
struct MeasuredDeviation {
  double to_max = 0, to_mean = 0;      ///< of the curve's points to the other
  double from_max = 0, from_mean = 0;  ///< of the other's points to the curve
  Point at = Point::Zero();            ///< the point with the larger maximum
};

struct MeasuredFile {
  std::string name;
  std::vector<MeasuredCurve> curves;
  MeasuredCurve total;
};

struct Measurement {
  std::size_t faces = 0, vertices = 0;  ///< of the mesh
  MeasuredFile file;
  std::optional<MeasuredFile> other;
  std::vector<MeasuredDeviation> deviations;  ///< of pairs; empty if the counts differ
  MeasuredDeviation deviation;                ///< of all curves
  std::vector<std::string> warnings;
};

std::string measure_table(const Measurement& m);
std::string measure_json(const Measurement& m);

}  // namespace talweg::driver

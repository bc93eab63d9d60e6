// A deviation measure selects the distance between two curves: along the surface or through space.
#pragma once

namespace talweg {

/// The distance between result and drawing in a report.
enum class DeviationMeasure {
  /// kAlongSurface for tau >= 1/8. For smaller tau, results may leave their drawings: kAlongSurface
  /// if result and drawing lie within four mean edges of each other, else kEuclidean. If exact
  /// distances would take far longer than smoothing, the report has bounds.
  kAutomatic,
  kAlongSurface,  ///< exact, along the surface; the cost grows with the deviation
  kEuclidean,     ///< through space: never longer than along the surface, and cheaper
  kNone,          ///< not measured: deviations are infinite in the report, null in JSON
};

}  // namespace talweg

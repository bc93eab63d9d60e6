// A deviation measure says along which ways the distance between two curves is taken.
#pragma once

namespace talweg {

/// Which distance between result and drawing a report has.
enum class DeviationMeasure {
  /// kAlongSurface, except below tau = 1/8, where results may leave their drawings: there it is
  /// used only if result and drawing lie within four mean edges of each other, and kEuclidean
  /// otherwise. Where exact distances would take far longer than smoothing, the report has bounds.
  kAutomatic,
  kAlongSurface,  ///< exact, along the surface; its cost grows with the deviation
  kEuclidean,     ///< through space: never more than kAlongSurface, and cheaper
  kNone,          ///< not measured: the report's deviations are infinite, null in JSON
};

}  // namespace talweg

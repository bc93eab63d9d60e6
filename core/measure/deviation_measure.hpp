// A deviation measure says along which ways the distance between two curves is taken.
#pragma once

namespace talweg {

/// Which distance between result and drawing a report has.
enum class DeviationMeasure {
  /// kAlongSurface; but below tau = 1/8, where results leave their drawings, only where they lie
  /// within four mean edges of each other, and through space where they do not.
  kAutomatic,
  kAlongSurface,  ///< exact, along the surface; its cost grows with the deviation
  kEuclidean,     ///< through space: never more, and cheaper
  kNone,          ///< none: the report's deviations are infinite, null in JSON
};

}  // namespace talweg

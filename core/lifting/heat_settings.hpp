// Heat settings say how the distance is computed by heat.
#pragma once

#include <optional>

namespace talweg {

struct HeatSettings {
  double time = 10;      ///< in units of h²; [1e-3, 1e6]
  unsigned threads = 2;  ///< at most; >= 1; no effect on results
  /// Unless empty, the distance is convolved with a bump of this radius, mesh units: see
  /// BumpOptions.
  std::optional<double> bump_radius;
};

}  // namespace talweg

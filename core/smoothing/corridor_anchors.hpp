// Anchors lead the corridor's result from one tau to the next, so that it follows a slider
// steadily.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/corridor.hpp"
#include "talweg/core/smoothing/corridor_hold.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Continuation in τ. A drawing is straightened once, at tau = 4 (the origin). From there the
/// curves are only polished, going down from one power of two (an anchor) to the next. The result
/// therefore follows tau without jumping between several nearly equal geodesics, and it does not
/// depend on what was asked for before. Upwards, the polish would not find its way back over the
/// ridges between two strands of the drawing, so each anchor above the origin is straightened on
/// its own. The curves that lead on to the next anchor are polished only a little; the curves from
/// which a result starts are polished in full, as a separate copy.
class CorridorAnchors {
 public:
  /// The anchor from which the result is polished: the power of two below its tau; none where the
  /// result is straightened on its own.
  static std::optional<double> anchor_of(const SmoothingOptions& options);

  void clear() { anchors_.clear(); }
  /// The result for options that have an anchor. Keeps the anchors as long as valleys and floor
  /// stay the same. Throws Cancelled.
  Smoothed smooth(CorridorHold& hold, const SmoothingOptions& options, const Progress& progress);
  /// The curves from which the full polish of the anchor would start. Keeps no anchors. Throws
  /// Cancelled.
  std::vector<SurfaceCurve> rough(CorridorHold& hold, const SmoothingOptions& options,
                                  const Progress& progress);

 private:
  struct Anchor {
    Straightened straight;               // at the origin, or at the anchor itself above it
    std::vector<SurfaceCurve> rough;     // polished a little, for the next anchor below
    std::vector<SurfaceCurve> polished;  // polished in full; empty until a result needs them
  };
  Anchor& at(double tau, CorridorHold& hold, const SmoothingOptions& options, StageTimes& times,
             const Progress& progress);
  void keep_for(const CorridorHold& hold, const SmoothingOptions& options);

  std::map<double, Anchor> anchors_;  // by tau, for the valleys and the floor below
  std::vector<Corridor::Valley> valleys_;
  double floor_ = 0;
};

}  // namespace talweg

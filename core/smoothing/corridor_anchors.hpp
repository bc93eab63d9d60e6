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

/// Continuation in τ. A drawing is straightened once, at the origin; from there the polish alone
/// goes down, from one power of two, an anchor, to the next. So the result follows tau without
/// jumping from one of several nearly equal geodesics to another, and is the same whatever was
/// asked before. Upwards the polish would not find its way back over the ridges between two strands
/// of the drawing: each anchor above the origin is straightened for itself. What leads on is
/// polished a little only; where curves start from an anchor it is polished in full, apart from
/// that.
class CorridorAnchors {
 public:
  /// From which anchor the result is polished: the power of two below its tau; none where it is
  /// straightened for itself.
  static std::optional<double> anchor_of(const SmoothingOptions& options);

  void clear() { anchors_.clear(); }
  /// The result for options with an anchor. Keeps anchors as long as valleys and floor are the
  /// same. Throws Cancelled.
  Smoothed smooth(CorridorHold& hold, const SmoothingOptions& options, const Progress& progress);
  /// From where the anchor's polish in full would start. Keeps none. Throws Cancelled.
  std::vector<SurfaceCurve> rough(CorridorHold& hold, const SmoothingOptions& options,
                                  const Progress& progress);

 private:
  struct Anchor {
    Straightened straight;               // of the anchor that it comes from
    std::vector<SurfaceCurve> rough;     // polished a little, for the next anchor below
    std::vector<SurfaceCurve> polished;  // once asked for
  };
  Anchor& at(double tau, CorridorHold& hold, const SmoothingOptions& options, StageTimes& times,
             const Progress& progress);
  void keep_for(const CorridorHold& hold, const SmoothingOptions& options);

  std::map<double, Anchor> anchors_;  // by tau, for the valleys and the floor below
  std::vector<Corridor::Valley> valleys_;
  double floor_ = 0;
};

}  // namespace talweg

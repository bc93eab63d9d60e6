// The corridor holds curves: they are straightened in its potential, then polished in it.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/smoothing/corridor.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/polish.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/straightening.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Holds a drawing in its valleys and runs one step of the method at a time, for one tau. Refers to
/// the objects it is made from; the distance is set to the curves of the valleys. All functions
/// throw Cancelled.
class CorridorHold {
 public:
  CorridorHold(EmbeddedDrawing& drawing, PolylineDistance& distance,
               const std::vector<Corridor::Valley>& valleys)
      : drawing_(&drawing), distance_(&distance), valleys_(&valleys) {}

  [[nodiscard]] const EmbeddedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return *valleys_; }

  /// Whether the distance must be exact everywhere, or only where valleys are narrow: a wall
  /// farther out that no curve climbs may be approximate.
  enum class Walls { kExact, kRough };
  Straightened straighten(const SmoothingOptions& options, Walls walls, const Progress& progress);
  /// The curves straightened without a lift, which needs no distance; none if the lift would change
  /// them.
  std::optional<Straightened> unlifted(const SmoothingOptions& options, const Progress& progress);
  /// Resets loops that collapsed because no vertex lies inside them to their drawing. FlipOut sees
  /// the potential at the mesh's vertices only, so it collapses these loops whatever tau is. The
  /// polish, which evaluates the potential on edges too, starts from the drawing instead.
  void hold_thin_loops(Straightened& straight) const;
  /// Polishes each curve separately; curves that cross afterwards are restored.
  void polish(double tau, std::vector<SurfaceCurve>& curves, const Progress& progress,
              const PolishOptions& options = {});

 private:
  [[nodiscard]] Corridor corridor(double tau) const { return {*distance_, tau, *valleys_}; }
  [[nodiscard]] double exact_for_walls() const;
  Straightened straighten_flat(const SmoothingOptions& options, const Progress& progress);
  [[nodiscard]] bool is_felt(const Corridor& corridor, const Straightened& flat,
                             const Progress& progress) const;

  EmbeddedDrawing* drawing_;
  PolylineDistance* distance_;
  const std::vector<Corridor::Valley>* valleys_;
};

}  // namespace talweg

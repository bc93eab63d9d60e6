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

/// A drawing in its valleys: one step at a time, for one tau. Refers to what it is made from; the
/// distance is set to what the valleys are of. Everything throws Cancelled.
class CorridorHold {
 public:
  CorridorHold(EmbeddedDrawing& drawing, PolylineDistance& distance,
               const std::vector<Corridor::Valley>& valleys)
      : drawing_(&drawing), distance_(&distance), valleys_(&valleys) {}

  [[nodiscard]] const EmbeddedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return *valleys_; }

  /// Whether the distance must be exact everywhere, or only where valleys are narrow: farther out
  /// a wall that nothing climbs may be rough.
  enum class Walls { kExact, kRough };
  Straightened straighten(const SmoothingOptions& options, Walls walls, const Progress& progress);
  /// The curves where nothing lifts them, which takes no distance; none where the lift is felt.
  std::optional<Straightened> unlifted(const SmoothingOptions& options, const Progress& progress);
  /// Loops that collapsed because no vertex lies inside them are their drawing again. FlipOut sees
  /// the potential at the mesh's vertices, so those collapse whatever tau is; the polish, which
  /// looks closer, starts from there instead.
  void hold_thin_loops(Straightened& straight) const;
  /// Polishes each curve for itself; those that this makes cross stay as they were.
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

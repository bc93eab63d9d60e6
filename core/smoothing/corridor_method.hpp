// The corridor's method smooths curves in valleys, by the exact distance to the drawing.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/fair_ladder.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Refers to the memory, whose distance it sets and uses, and to the drawing. All functions throw
/// Cancelled. A smoothing costs the fairings of FairLadder and FairFinishing, and a straightening
/// if they need it.
class CorridorMethod {
 public:
  CorridorMethod(SmoothingMemory& memory, EmbeddedDrawing& drawing)
      : memory_(&memory), drawing_(&drawing) {}

  /// Sets the distance to the drawing, and computes its valleys.
  void solve(const Progress& progress);
  /// Sets the distance to the given curves, with the given valleys; used for a stretch of a
  /// drawing.
  void set(std::span<const SurfaceCurve> near, std::vector<Corridor::Valley> valleys,
           const Progress& progress);
  /// Must be called after the drawing's pins have changed.
  void pins_changed() { ladder_.clear(); }

  /// Per curve, before options change it.
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return valleys_; }

  DomainResult smooth(const SmoothingOptions& options, const Progress& progress);
  /// Like smooth(), but in the valleys of set() or solve(), without the slack and turns of the
  /// options.
  DomainResult smooth_in_own_valleys(const SmoothingOptions& options, const Progress& progress);
  /// The straightened curves for these options, in the valleys of set() or solve().
  std::vector<SurfaceCurve> taut(const SmoothingOptions& options, const Progress& progress);
  /// CorridorSolver::fair() in the valleys of set() or solve().
  std::optional<SurfaceCurve> fair(double tau, const SurfaceCurve& curve,
                                   std::span<const SurfacePoint> fixed, const Progress& progress);

 private:
  DomainResult smooth_in(const std::vector<Corridor::Valley>& valleys,
                         const SmoothingOptions& options, const Progress& progress);

  SmoothingMemory* memory_;
  EmbeddedDrawing* drawing_;
  std::vector<Corridor::Valley> valleys_;
  FairLadder ladder_;
};

}  // namespace talweg

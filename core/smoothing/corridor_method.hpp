// The corridor's method smooths curves by the exact distance near the drawing, in valleys.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/fair_ladder.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Refers to the memory, whose distance it uses, and to the drawing. All functions throw Cancelled.
/// A smoothing costs the fairings of FairLadder and FairFinishing, and a straightening where these
/// ask for it.
class CorridorMethod {
 public:
  CorridorMethod(SmoothingMemory& memory, EmbeddedDrawing& drawing)
      : memory_(&memory), drawing_(&drawing) {}

  /// Measures from the drawing and finds its valleys.
  void solve(const Progress& progress);
  /// Measures from these curves, with their valleys, instead; used for a stretch of a drawing.
  void set(std::span<const SurfaceCurve> near, std::vector<Corridor::Valley> valleys,
           const Progress& progress);
  /// To be called after the drawing's pins have changed.
  void pins_changed() { ladder_.clear(); }

  /// Per curve, before options change them.
  [[nodiscard]] const std::vector<Corridor::Valley>& valleys() const { return valleys_; }

  DomainResult smooth(const SmoothingOptions& options, const Progress& progress);
  /// Like smooth(), but in the valleys as they are, without the options' slack and turns.
  DomainResult smooth_in_own_valleys(const SmoothingOptions& options, const Progress& progress);
  /// The straightened curves from which fair ones for these options start, in the valleys as they
  /// are.
  std::vector<SurfaceCurve> taut(const SmoothingOptions& options, const Progress& progress);
  /// A fair curve near the first drawn one, in its valley as it is; these points of it and its ends
  /// stay. None where samples cannot be joined.
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

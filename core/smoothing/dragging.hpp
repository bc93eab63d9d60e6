// Dragging smooths only the stretch of a drawing that the user moves.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/smoothing/corridor_method.hpp"
#include "talweg/core/smoothing/drag_stretch.hpp"
#include "talweg/core/smoothing/drawing_change.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Holds separate working memory for the stretches.
class Dragging {
 public:
  /// O(mesh).
  explicit Dragging(std::shared_ptr<const OpenedMesh> mesh) : memory_(std::move(mesh)) {}

  /// The drawing that is set, with its options and valleys.
  struct Setting {
    const OrderedDrawing& drawing;
    const CurveOptions& curve_options;
    const std::vector<Corridor::Valley>& valleys;  ///< of the drawing's curves, in canonical order
    const SmoothingOptions& options;
  };
  /// Approximates the result of curve number `curve` (in drawn order) after the change: `last`, its
  /// result before the change, with the changed stretch smoothed again. If no stretch can be joined
  /// to `last`, the whole curve is smoothed again. Throws Cancelled.
  SurfaceCurve dragged(const Setting& setting, std::size_t curve, const DrawingChange& change,
                       const SurfaceCurve& last, const Progress& progress);

 private:
  struct Range;
  /// A stretch, embedded for smoothing.
  struct Stretch {
    OrderedDrawing drawing;
    std::optional<EmbeddedDrawing> embedded;
    std::optional<CorridorMethod> method;
  };
  void set(const DragStretch& stretch, const CurveOptions& options, const Progress& progress);
  [[nodiscard]] std::optional<Range> range_around(const DrawingChange& change, double margin) const;
  std::optional<SurfaceCurve> joined(const Range& range, const DrawingChange& change, double margin,
                                     const SurfaceCurve& last, const SmoothingOptions& options,
                                     const Progress& progress);

  SmoothingMemory memory_;
  Stretch stretch_;
};

}  // namespace talweg

// An embedded drawing consists of edge paths in the triangulation of a mesh, for straightening.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The curves with their corners capped, if the options require it.
std::vector<SurfaceCurve> capped_curves(const Surface& surface,
                                        std::span<const SurfaceCurve> curves,
                                        const CurveOptions& options);

/// The common part of all smoothing methods. Refers to the memory and the drawing. Costs legs_of()
/// for each curve, and embedding and runs of Straightening.
class EmbeddedDrawing {
 public:
  struct Ground {
    Loops loops = Loops::kKeep;  ///< whether loops stay; on strips they are erased
    /// For a part of a mesh: per vertex, whether the surface was cut off there. Null for a whole
    /// mesh.
    const std::vector<bool>* fence = nullptr;
  };
  /// Caps the corners and embeds the curves. Throws as embed_curves() does, and Cancelled.
  EmbeddedDrawing(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
                  Ground ground, const Progress& progress);

  /// Embeds the curves again, with new pins. Throws Cancelled.
  void set_pins(std::vector<SurfacePoint> pins, const Progress& progress);

  /// Allows curves that consist of legs only to cross themselves and each other, because their legs
  /// can be straightened one by one. `crossings`: their number in the drawing. False, without a
  /// change, if a curve has strokes or the legs cannot be straightened. Throws Cancelled.
  bool let_legs_cross(std::size_t crossings, const Progress& progress);
  [[nodiscard]] bool may_cross() const { return may_cross_; }
  /// The number of crossings in the drawing, as given to let_legs_cross().
  [[nodiscard]] std::size_t crossings() const { return crossings_; }

  /// Whether loops of the curves are erased.
  [[nodiscard]] bool erases_loops() const { return ground_.loops == Loops::kErase; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return memory_->mesh(); }
  [[nodiscard]] const Surface& surface() const { return memory_->surface(); }
  [[nodiscard]] const Straightening& straightening() const {
    return std::as_const(*memory_).straightening();
  }
  /// The curvature of strips of surface beside curves.
  [[nodiscard]] StripCurvature& curvature() { return memory_->curvature(); }
  [[nodiscard]] const OrderedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const CurveOptions& options() const { return options_; }
  [[nodiscard]] const std::vector<SurfacePoint>& pins() const { return options_.pins; }
  [[nodiscard]] const std::vector<SurfacePoint>& corners() const { return options_.corners; }
  /// Pins, corners and way-points, which straightened curves pass through.
  [[nodiscard]] const std::vector<SurfacePoint>& fixed() const { return fixed_; }
  /// The legs of each curve.
  [[nodiscard]] const std::vector<DrawnLegs>& legs() const { return legs_; }
  /// Whether some curve has legs; whether all curves consist of legs only.
  [[nodiscard]] bool any_legs() const;
  [[nodiscard]] bool all_legs() const;
  /// The curves with their corners capped.
  [[nodiscard]] const std::vector<SurfaceCurve>& capped() const { return capped_; }
  /// Total length of all drawn curves, mesh units.
  [[nodiscard]] double drawn_length() const;
  /// The length below which a loop counts as collapsed, mesh units: the option, or a few edges.
  [[nodiscard]] double length_floor(const SmoothingOptions& options) const;

  /// Straightens the curves in a metric. Throws Cancelled.
  Straightened straighten(const SmoothingOptions& options, SignpostTriangulation::Metric metric,
                          const Progress& progress);
  /// The curves with their legs straightened one by one, and their strokes as drawn; empty if the
  /// legs must be straightened together. Throws Cancelled.
  std::optional<Straightened> straighten_legs(const SmoothingOptions& options,
                                              const Progress& progress);
  /// Straightens the curves without a lift. The result does not depend on tau, so it is kept; a
  /// kept result has times of 0. Throws Cancelled.
  Straightened straighten_flat(const SmoothingOptions& options, const Progress& progress);

 private:
  /// The curves straightened without a lift, and the options of this straightening.
  struct Flat {
    Straightening::Options options;
    Straightened straight;
  };
  void embed(const Progress& progress);
  void embed_curves(const Progress& progress);
  [[nodiscard]] Straightening::Options straightening_options(const SmoothingOptions& options) const;
  [[nodiscard]] bool may_straighten_legs(const Straightening::Options& options) const;

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  Ground ground_;
  std::vector<SurfaceCurve> capped_;
  std::vector<SurfacePoint> fixed_;
  std::vector<DrawnLegs> legs_;
  bool may_cross_ = false;
  std::size_t crossings_ = 0;
  bool is_embedded_ = false;  // false after straightening legs one by one
  std::optional<Flat> flat_;
};

}  // namespace talweg

// An embedded drawing lies in the triangulation of a mesh, ready to be straightened there.
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

/// The curves with their corners capped, if the options say so.
std::vector<SurfaceCurve> capped_curves(const Surface& surface,
                                        std::span<const SurfaceCurve> curves,
                                        const CurveOptions& options);

/// The part that all smoothing methods share. Refers to the memory and the drawing it is made from.
/// Costs legs_of() for each curve, and what Straightening needs to embed the curves and to run.
class EmbeddedDrawing {
 public:
  struct Ground {
    Loops loops = Loops::kKeep;  ///< what becomes of loops; on strips they are removed
    /// For a part of a mesh: per vertex, whether the surface was cut off there. Null means nowhere.
    const std::vector<bool>* fence = nullptr;
  };
  /// Caps the corners and embeds the curves. Throws as embed_curves() does, and Cancelled.
  EmbeddedDrawing(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
                  Ground ground, const Progress& progress);

  /// Embeds the curves once more, with these pins. Throws Cancelled.
  void set_pins(std::vector<SurfacePoint> pins, const Progress& progress);

  /// Lets curves that are all legs cross themselves and each other from now on, because their legs
  /// are straightened each for itself. False, and nothing changes, where that is not possible.
  /// Throws Cancelled.
  bool let_legs_cross(std::size_t crossings, const Progress& progress);
  [[nodiscard]] bool may_cross() const { return may_cross_; }
  /// How often they cross as they are drawn, in all.
  [[nodiscard]] std::size_t crossings() const { return crossings_; }

  /// Whether loops of the curves are erased.
  [[nodiscard]] bool erases_loops() const { return ground_.loops == Loops::kErase; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return memory_->mesh(); }
  [[nodiscard]] const Surface& surface() const { return memory_->surface(); }
  [[nodiscard]] const Straightening& straightening() const {
    return std::as_const(*memory_).straightening();
  }
  /// Of the surface beside curves.
  [[nodiscard]] StripCurvature& curvature() { return memory_->curvature(); }
  [[nodiscard]] const OrderedDrawing& drawing() const { return *drawing_; }
  [[nodiscard]] const CurveOptions& options() const { return options_; }
  [[nodiscard]] const std::vector<SurfacePoint>& pins() const { return options_.pins; }
  [[nodiscard]] const std::vector<SurfacePoint>& corners() const { return options_.corners; }
  /// Pins, corners and way-points: what straightening passes through.
  [[nodiscard]] const std::vector<SurfacePoint>& fixed() const { return fixed_; }
  /// Per curve.
  [[nodiscard]] const std::vector<DrawnLegs>& legs() const { return legs_; }
  /// Whether a curve has legs, and whether every curve is of nothing else.
  [[nodiscard]] bool any_legs() const;
  [[nodiscard]] bool all_legs() const;
  /// The curves with their corners capped.
  [[nodiscard]] const std::vector<SurfaceCurve>& capped() const { return capped_; }
  /// Total length of all curves as they were drawn, mesh units.
  [[nodiscard]] double drawn_length() const;
  /// The length below which a loop counts as collapsed, mesh units: the option, or a handful of
  /// edges.
  [[nodiscard]] double length_floor(const SmoothingOptions& options) const;

  /// Straightens the curves in a metric. Throws Cancelled.
  Straightened straighten(const SmoothingOptions& options, SignpostTriangulation::Metric metric,
                          const Progress& progress);
  /// The curves with their legs straightened, each for itself, and their strokes as drawn; none
  /// where they are to be straightened together. Throws Cancelled.
  std::optional<Straightened> straighten_legs(const SmoothingOptions& options,
                                              const Progress& progress);
  /// Straightens the curves without a lift. That depends on no tau, so it is kept; the times of one
  /// that is known are 0. Throws Cancelled.
  Straightened straighten_flat(const SmoothingOptions& options, const Progress& progress);

 private:
  /// The curves straightened without a lift, and the options that matter for it.
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
  bool is_embedded_ = false;  // not while the legs are straightened, each for itself
  std::optional<Flat> flat_;
};

}  // namespace talweg

// A smoother takes drawn curves on an opened mesh and smooths them for one tau after another.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/drawing/draw.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

class Dragging;
struct CleanedDrawing;
class OrderedDrawing;
class Sheet;
class SmoothingMemory;
struct GivenPotential;

/// Smooths curves on one opened mesh. Holds the working memory, which is allocated once. One thread
/// at a time may use a smoother; any number of smoothers may share an opened mesh.
///
///   CurveSmoother smoother(OpenedMesh::open(lists));
///   smoother.set_curve(curve);  // or: set_curve(draw(surface, clicks))
///   SmoothingResult result = smoother.smooth(2.0);
class CurveSmoother {
 public:
  /// O(mesh), once.
  explicit CurveSmoother(std::shared_ptr<const OpenedMesh> mesh);
  ~CurveSmoother();

  /// Sets the drawing: checks and embeds it and makes the distance to it ready. False when
  /// cancelled; no curve is set then. Throws Error(kBadCurve) for a curve that check_drawn() or
  /// embed_curves() refuse (no curve is set then), Error(kBadUsage) for bad options or a pin that
  /// is not on it.
  bool set_curve(const SurfaceCurve& curve, const CurveOptions& options = {},
                 const Progress& progress = {});
  /// Sets what draw() has drawn; its way-points are added to those of the options.
  bool set_curve(const Drawing& drawing, const CurveOptions& options = {},
                 const Progress& progress = {});
  /// Sets several curves: the distance is to their union, and straightening makes none cross
  /// another. If curves are drawn across themselves or each other, each is smoothed separately, on
  /// a strip of surface of its own (unroll()), and the distance is to the curve's own part there.
  bool set_curves(std::span<const SurfaceCurve> curves, const CurveOptions& options = {},
                  const Progress& progress = {});
  /// Like set_curves() above, with a distance given by the caller, one value per mesh vertex, used
  /// as it is. It may be negative, and +infinity in components without a curve. The method is
  /// always Method::kPaper.
  bool set_curves(std::span<const SurfaceCurve> curves, std::vector<double> distance,
                  const CurveOptions& options = {}, const Progress& progress = {});

  /// Computes the paper's distance if it has not been computed yet. False when cancelled. Throws
  /// Error(kBadUsage) when no curve is set.
  bool need_distance(const Progress& progress = {});

  /// Changes the pins of the curves that are set, with the same results as set_curves() with these
  /// pins; the distance stays as it is, unless pins change what is left out of a stroke. Only for
  /// the corridor. False when cancelled; the pins are then unchanged. Throws Error(kBadUsage) for a
  /// pin that is not a point of the drawing, or for another method.
  bool set_pins(std::span<const SurfacePoint> pins, const Progress& progress = {});

  /// The smoothed curves. The cost depends on what the curves touch, not on the size of the mesh.
  /// Where nothing is lifted (tau is 0, or so small that it lengthens no edge by 1e-7 of its
  /// length), no distance is computed either. When cancelled, the curves are those drawn,
  /// `termination` says so, and the smoother is in the state it had before the call. Throws
  /// Error(kBadUsage) when no curve is set or an option is out of range.
  SmoothingResult smooth(double tau = 1);
  SmoothingResult smooth(const SmoothingOptions& options, const Progress& progress = {});
  /// Smooths with a potential given by the caller: row by row k values per mesh vertex (n x k, mesh
  /// units). Throws Error(kBadUsage) when the size is not n x k or a value at the curve is not
  /// finite.
  SmoothingResult smooth(const SmoothingOptions& options, std::span<const double> potential,
                         std::size_t components, const Progress& progress = {});

  /// A preview while a part of a drawing is being dragged: approximately the result that the
  /// drawing would have if curve number `curve` were changed to `moved`, in time proportional to
  /// the changed part. Only the stretch that differs from the drawing that is set is smoothed anew
  /// and joined to the last result. Slack and L stay those of the drawing that is set, and the
  /// curve is not kept from crossing others. `engine` of its report is "preview". The drawing that
  /// is set does not change: set_curve(moved) gives the final result. The same arguments give the
  /// same curve, whatever was dragged before. Only for the corridor; where tau is 0 or the result
  /// is relaxed, everything is smoothed anew. Throws Error(kBadCurve) as set_curve() does,
  /// Error(kBadUsage) for a curve that does not exist or another method. When cancelled, the result
  /// is as for smooth(), with `moved` as that curve.
  SmoothingResult drag(std::size_t curve, const SurfaceCurve& moved,
                       const SmoothingOptions& options = {}, const Progress& progress = {});

  /// The same where clicks are moved: the way-points of this curve are those of `moved`. The curve
  /// is faired as a whole, and legs that are drawn anew are straightened, so that the preview is
  /// the final result.
  SmoothingResult drag(std::size_t curve, const Drawing& moved,
                       const SmoothingOptions& options = {}, const Progress& progress = {});

  [[nodiscard]] const OpenedMesh& opened() const;
  /// The distance per mesh vertex that was given or has been computed so far: see need_distance().
  [[nodiscard]] std::span<const double> distance() const;
  /// The curves as they were set, before anything was left out of them.
  [[nodiscard]] std::span<const SurfaceCurve> drawn() const;
  /// The points of the drawing that every result passes through.
  [[nodiscard]] std::span<const SurfacePoint> pins() const { return curve_options_.pins; }
  /// As they were set, with the pins of now.
  [[nodiscard]] const CurveOptions& curve_options() const { return curve_options_; }
  /// The corridor's slack for each curve where the options give none, mesh units:
  /// stroke_slack(), less for loops that would collapse at tau = 1/4. Empty for the paper's method.
  [[nodiscard]] std::vector<double> slack() const;

 private:
  void forget();
  [[nodiscard]] SmoothingOptions on_cleaned(SmoothingOptions options) const;
  [[nodiscard]] SurfaceCurve cleaned_as(std::size_t curve, const SurfaceCurve& moved,
                                        const Progress& progress) const;
  void check(const SmoothingOptions& options) const;
  bool set(std::span<const SurfaceCurve> curves, const CurveOptions& options,
           std::optional<std::vector<double>> distance, const Progress& progress);
  [[nodiscard]] bool is_cleaned_alike(const CurveOptions& options, const Progress& progress) const;
  bool set_anew(const CurveOptions& options, const Progress& progress);
  SmoothingResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                         const Progress& progress);
  SmoothingResult smooth_ordered(const SmoothingOptions& options, const GivenPotential* given,
                                 const Progress& progress);
  void report_moves(const SmoothingOptions& options, SmoothingResult& result,
                    const Progress& progress) const;
  SmoothingResult drag_now(std::size_t curve, const SurfaceCurve& moved,
                           const SmoothingOptions& options, const Progress& progress);
  [[nodiscard]] CurveOptions options_of_moved(std::span<const SurfaceCurve> curves,
                                              std::size_t moved,
                                              std::span<const WayPoint> way_points) const;
  SmoothingResult drag_whole(std::size_t curve, const Drawing& moved,
                             const SmoothingOptions& options, const Progress& progress);
  SmoothingResult last_for(const SmoothingOptions& options, const Progress& progress);

  struct Last;
  std::unique_ptr<SmoothingMemory> memory_;
  std::vector<SurfaceCurve> given_;
  std::unique_ptr<CleanedDrawing> cleaned_;  // of those that were given
  std::unique_ptr<OrderedDrawing> drawing_;  // of what is left of them
  CurveOptions curve_options_;
  double roughness_ = 0;                      // roughness_along() the drawing
  std::unique_ptr<Sheet> sheet_;              // null where no curve is set
  std::unique_ptr<Last> last_;                // the last result of smooth(), on the ordered curves
  std::unique_ptr<Dragging> dragging_;        // made when first needed, as is previewer_
  std::unique_ptr<CurveSmoother> previewer_;  // for drag() where a stretch is not enough
};

/// Smooths one curve in one call, with a CurveSmoother for it alone.
SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options = {},
                             const CurveOptions& curve_options = {}, const Progress& progress = {});

}  // namespace talweg

// A curve smoother smooths drawn curves on an opened mesh, for one tau after another.
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
class SmoothingDomain;
class SmoothingMemory;
struct GivenPotential;

/// Smooths curves on one opened mesh. A smoother holds the working memory, which is allocated once.
/// One thread at a time may use a smoother; any number of smoothers may share an opened mesh.
///
///   CurveSmoother smoother(OpenedMesh::open(lists));
///   smoother.set_curve(curve);  // or: set_curve(draw(surface, clicks))
///   SmoothingResult result = smoother.smooth(2.0);
class CurveSmoother {
 public:
  /// O(mesh), once.
  explicit CurveSmoother(std::shared_ptr<const OpenedMesh> mesh);
  ~CurveSmoother();

  /// Sets the drawing: checks and embeds the curve, and prepares the distance to it. False when
  /// cancelled. Throws Error(kBadCurve) for a curve that check_drawn() or embed_curves() reject,
  /// Error(kBadUsage) for bad options or a pin that is not a point of the curve. If cancelled or
  /// after an error, no curve is set.
  bool set_curve(const SurfaceCurve& curve, const CurveOptions& options = {},
                 const Progress& progress = {});
  /// Sets a result of draw(); its way-points are added to the options.
  bool set_curve(const Drawing& drawing, const CurveOptions& options = {},
                 const Progress& progress = {});
  /// Sets several curves: the distance is to their union, and straightening adds no crossings.
  /// Curves that are drawn across themselves or each other are smoothed separately, each on its own
  /// strip of surface (unroll()), with the distance to the curve's own part on the strip.
  bool set_curves(std::span<const SurfaceCurve> curves, const CurveOptions& options = {},
                  const Progress& progress = {});
  /// set_curves() with a given distance, one value per mesh vertex, used unchanged. Values may be
  /// negative, and +infinity in components without a curve. The method is always Method::kPaper.
  bool set_curves(std::span<const SurfaceCurve> curves, std::vector<double> distance,
                  const CurveOptions& options = {}, const Progress& progress = {});

  /// Computes the paper's distance if it is not known. False when cancelled. Throws
  /// Error(kBadUsage) if no curve is set.
  bool need_distance(const Progress& progress = {});

  /// Changes the pins of the curves that are set, with the same results as set_curves() with these
  /// pins; the distance is kept unless the pins change the cleaning of a stroke. Only for the
  /// corridor. False when cancelled; the pins are then unchanged. Throws Error(kBadUsage) for a pin
  /// that is not a point of the drawing, or for another method.
  bool set_pins(std::span<const SurfacePoint> pins, const Progress& progress = {});

  /// Smooths the curves. The cost depends on the faces near the curves, not on the size of the
  /// mesh. Without an effective lift (tau is 0, or lengthens no edge by 1e-7 of its length), no
  /// distance is computed. When cancelled, the result has the drawn curves and the termination
  /// kCancelled, and the smoother is unchanged. Throws Error(kBadUsage) if no curve is set or an
  /// option is out of range.
  SmoothingResult smooth(double tau = 1);
  SmoothingResult smooth(const SmoothingOptions& options, const Progress& progress = {});
  /// Smooths with a given potential: row by row k = `components` values per mesh vertex (n x k,
  /// mesh units). Throws Error(kBadUsage) if the size is not n x k or a value is not a number of at
  /// most 1e150.
  SmoothingResult smooth(const SmoothingOptions& options, std::span<const double> potential,
                         std::size_t components, const Progress& progress = {});

  /// A preview while a part of a drawing is dragged: approximately the result after changing curve
  /// number `curve` to `moved`, in time proportional to the changed part. Only the stretch that
  /// differs from the drawing that is set is smoothed again and joined to the last result. Slack
  /// and L stay those of the drawing that is set, and the preview may cross other curves. Its
  /// report has the engine "preview". The drawing that is set does not change: set_curve(moved)
  /// gives the final result. The result depends on the arguments only, not on earlier calls of
  /// drag(). Only for the corridor; if tau is 0 or the result is relaxed, the whole curve is
  /// smoothed again. Throws Error(kBadCurve) as set_curve() does, Error(kBadUsage) for a curve that
  /// does not exist or another method. When cancelled, the result is as for smooth(), with `moved`
  /// as curve number `curve`.
  SmoothingResult drag(std::size_t curve, const SurfaceCurve& moved,
                       const SmoothingOptions& options = {}, const Progress& progress = {});

  /// drag() for moved clicks: the way-points of the curve are those of `moved`. The whole curve is
  /// straightened and faired, so the preview equals the final result.
  SmoothingResult drag(std::size_t curve, const Drawing& moved,
                       const SmoothingOptions& options = {}, const Progress& progress = {});

  [[nodiscard]] const OpenedMesh& opened() const;
  /// The paper's distance per mesh vertex, given or computed (need_distance()); empty if not known.
  [[nodiscard]] std::span<const double> distance() const;
  /// The curves as set, before cleaning.
  [[nodiscard]] std::span<const SurfaceCurve> drawn() const;
  /// The pins of the drawing, which every result passes through.
  [[nodiscard]] std::span<const SurfacePoint> pins() const { return curve_options_.pins; }
  /// The curve options as set, with the current pins.
  [[nodiscard]] const CurveOptions& curve_options() const { return curve_options_; }
  /// The corridor's default slack per curve, mesh units: stroke_slack(), narrowed to keep curves
  /// apart (valleys_of()). Empty for the paper's method.
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
  std::unique_ptr<CleanedDrawing> cleaned_;  // of given_
  std::unique_ptr<OrderedDrawing> drawing_;  // of cleaned_
  CurveOptions curve_options_;
  double roughness_ = 0;                      // roughness_along() of the drawing
  std::unique_ptr<SmoothingDomain> domain_;   // null if no curve is set
  std::unique_ptr<Last> last_;                // the last result of smooth(), in canonical order
  std::unique_ptr<Dragging> dragging_;        // made on first use
  std::unique_ptr<CurveSmoother> previewer_;  // for drag_whole(); made on first use
};

/// Smooths one curve in one call, with a CurveSmoother that is made for it.
SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options = {},
                             const CurveOptions& curve_options = {}, const Progress& progress = {});

}  // namespace talweg

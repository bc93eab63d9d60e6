// A smoother takes drawn curves on an opened mesh and smooths them for one tau after another.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

class Dragging;
class OrderedDrawing;
class Sheet;
class SmoothingMemory;
struct GivenPotential;

/// Smooths curves on one opened mesh. Holds the working memory, which is made once; one thread at a
/// time per smoother, any number of smoothers per opened mesh.
///
///   CurveSmoother smoother(OpenedMesh::open(lists));
///   smoother.set_curve(curve);
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
  /// A set of curves: the distance is to their union, and none crosses another by straightening.
  /// Curves that are drawn across themselves or each other are smoothed each for itself, on a strip
  /// of surface of its own (unroll()); the distance is to the curve's own part there.
  bool set_curves(std::span<const SurfaceCurve> curves, const CurveOptions& options = {},
                  const Progress& progress = {});
  /// The same with a distance of the caller's, one value per mesh vertex, used as it is; it may be
  /// negative, and +infinity in components without a curve. Always Method::kPaper.
  bool set_curves(std::span<const SurfaceCurve> curves, std::vector<double> distance,
                  const CurveOptions& options = {}, const Progress& progress = {});

  /// The paper's distance, if it has not been computed yet. False when cancelled.
  /// Throws Error(kBadUsage) when no curve is set.
  bool need_distance(const Progress& progress = {});

  /// Other pins for the curves that are set; the distance stays as it is. With the corridor only.
  /// False when cancelled; the pins are what they were then.
  /// Throws Error(kBadUsage) for a pin that is not a point of the drawing, or another method.
  bool set_pins(std::span<const SurfacePoint> pins, const Progress& progress = {});

  /// The smoothed curves. Costs what the curves touch, whatever the size of the mesh; where nothing
  /// is lifted (tau = 0, or so small that it lengthens no edge by 1e-7 of it) no distance either.
  /// When cancelled the curves are those drawn, `termination` says so, and the smoother is as if it
  /// had not been asked.
  /// Throws Error(kBadUsage) when no curve is set or an option is out of range.
  SmoothingResult smooth(double tau = 1);
  SmoothingResult smooth(const SmoothingOptions& options, const Progress& progress = {});
  /// With a potential of the caller's, row by row k values per mesh vertex (n x k, mesh units).
  /// Throws Error(kBadUsage) when the size is not n x k or a value at the curve is not finite.
  SmoothingResult smooth(const SmoothingOptions& options, std::span<const double> potential,
                         std::size_t components, const Progress& progress = {});

  /// While a part of a drawing is being dragged: about the result that the drawing would have if
  /// curve number `curve` were changed to `moved`, in the time that the part takes. Only the
  /// stretch that differs from the drawing that is set is smoothed anew, and joined to the last
  /// result; slack and L stay those of that drawing, and the curve is not kept from crossing
  /// others. `engine` of its report is "preview". The drawing that is set stays: set_curve(moved)
  /// gives what counts. The same arguments give the same curve, whatever was dragged before. With
  /// the corridor only; where tau is 0 or the result is relaxed everything is smoothed anew. Throws
  /// Error(kBadCurve) as set_curve() does, Error(kBadUsage) for a curve that is not there or
  /// another method. When cancelled as smooth() is, with `moved` as that curve.
  SmoothingResult drag(std::size_t curve, const SurfaceCurve& moved,
                       const SmoothingOptions& options = {}, const Progress& progress = {});

  [[nodiscard]] const OpenedMesh& opened() const;
  /// The distance per mesh vertex that was given, or computed so far: see need_distance().
  [[nodiscard]] std::span<const double> distance() const;
  /// The curves as they were set.
  [[nodiscard]] std::span<const SurfaceCurve> drawn() const;
  /// The points of them that stay.
  [[nodiscard]] std::span<const SurfacePoint> pins() const { return curve_options_.pins; }
  /// The corridor's slack for each curve where no other is asked for, mesh units: default_slack(),
  /// less for loops that would collapse at tau = 1/4. Empty for the paper's method.
  [[nodiscard]] std::vector<double> slack() const;

 private:
  void forget();
  void check(const SmoothingOptions& options) const;
  bool set(std::span<const SurfaceCurve> curves, const CurveOptions& options,
           std::optional<std::vector<double>> distance, const Progress& progress);
  SmoothingResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                         const Progress& progress);
  SmoothingResult smooth_ordered(const SmoothingOptions& options, const GivenPotential* given,
                                 const Progress& progress);
  void report_moves(const SmoothingOptions& options, SmoothingResult& result,
                    const Progress& progress) const;
  SmoothingResult drag_now(std::size_t curve, const SurfaceCurve& moved,
                           const SmoothingOptions& options, const Progress& progress);
  SmoothingResult drag_whole(std::size_t curve, const SurfaceCurve& moved,
                             const SmoothingOptions& options, const Progress& progress);
  SmoothingResult last_for(const SmoothingOptions& options, const Progress& progress);

  struct Last;
  std::unique_ptr<SmoothingMemory> memory_;
  std::unique_ptr<OrderedDrawing> drawing_;
  CurveOptions curve_options_;
  std::unique_ptr<Sheet> sheet_;              // null where no curve is set
  std::unique_ptr<Last> last_;                // of smooth(), on the ordered curves
  std::unique_ptr<Dragging> dragging_;        // made when first needed, as is the next
  std::unique_ptr<CurveSmoother> previewer_;  // where a stretch is not enough
};

/// One curve in one call: CurveSmoother for it alone.
SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options = {},
                             const CurveOptions& curve_options = {}, const Progress& progress = {});

}  // namespace talweg

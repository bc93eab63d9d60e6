// The method, end to end: open a mesh, set a curve, smooth for a tau.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "talweg/core/measure/report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/smoothing/corridor.hpp"
#include "talweg/core/smoothing/drag_stretch.hpp"
#include "talweg/core/smoothing/drawing_change.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/paper_lift.hpp"
#include "talweg/core/smoothing/polish.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"
#include "talweg/core/smoothing/straightening.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

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
  SmoothingResult smooth(const SmoothingOptions& options);
  /// With a potential of the caller's, row by row k values per mesh vertex (n x k, mesh units).
  /// Throws Error(kBadUsage) when the size is not n x k or a value at the curve is not finite.
  SmoothingResult smooth(const SmoothingOptions& options, std::span<const double> potential,
                         std::size_t components);

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
                       const SmoothingOptions& options = {});

  [[nodiscard]] const OpenedMesh& opened() const { return *mesh_; }
  /// The distance per mesh vertex that was given, or computed so far: see need_distance().
  [[nodiscard]] std::span<const double> distance() const { return lift_.distance(); }
  /// The curves as they were set.
  [[nodiscard]] std::span<const SurfaceCurve> drawn() const { return drawing_.drawn(); }
  /// The points of them that stay.
  [[nodiscard]] std::span<const SurfacePoint> pins() const { return curve_options_.pins; }
  /// The corridor's slack for each curve where no other is asked for, mesh units: default_slack(),
  /// less for loops that would collapse at tau = 1/4. Empty for the paper's method.
  [[nodiscard]] std::vector<double> slack() const;
  /// The drawn curves, in their canonical_order() and that of the set, corners capped, that are
  /// being smoothed.
  [[nodiscard]] std::span<const SurfaceCurve> capped() const { return capped_; }

 private:
  // smooth_unrolled.cpp
  struct Unrolled;
  [[nodiscard]] bool is_set() const {
    return unrolled_ != nullptr || !refined_.empty() || !straightening_.paths().empty();
  }
  [[nodiscard]] std::vector<bool> tangled() const;
  bool set_unrolled_pins(const Progress& progress);
  [[nodiscard]] std::vector<std::string> lost_pins(std::span<const SurfaceCurve> results) const;
  [[nodiscard]] std::vector<double> unrolled_slack() const;
  void set_unrolled(const std::vector<bool>& alone, const Progress& progress);
  [[nodiscard]] std::vector<SurfacePoint> unrolled_pins(std::span<const SurfaceCurve> curves,
                                                        std::span<const SurfacePoint> pins) const;
  SmoothingResult smooth_unrolled(const SmoothingOptions& options);
  SmoothingResult smooth_unrolled(const SmoothingOptions& options,
                                  std::span<const double> potential, std::size_t components);
  SmoothingResult folded(SmoothingResult result, const Progress& progress);
  // smooth_refined.cpp
  struct Refined;
  [[nodiscard]] std::vector<FaceId> faces_to_divide() const;
  std::unique_ptr<Refined> refined_within(double reach, const Progress& progress);
  void set_refined(const Progress& progress);
  [[nodiscard]] double refined_reach() const;
  [[nodiscard]] std::vector<SurfacePoint> refined_pins(const Refined& refined,
                                                       std::span<const SurfaceCurve> curves) const;
  bool set_refined_pins(const Progress& progress);
  [[nodiscard]] std::vector<double> refined_slack() const;
  [[nodiscard]] std::vector<double> refined_slack_at(const Refined& refined, std::size_t curve,
                                                     const std::vector<double>& drawn) const;
  static bool is_at_cut(const Refined& refined, const SmoothingResult& result);
  template <class Smooth>
  SmoothingResult in_reach(const SmoothingOptions& options, const Smooth& smooth);
  SmoothingResult smooth_refined(const SmoothingOptions& options);
  SmoothingResult smooth_refined(const SmoothingOptions& options, std::span<const double> potential,
                                 std::size_t components);
  SmoothingResult coarse(const Refined& refined, SmoothingResult result,
                         const SmoothingOptions& options);

  [[nodiscard]] SmoothingOptions with_ordered_slack(SmoothingOptions options) const;
  [[nodiscard]] SmoothingResult cancelled_result(const SmoothingOptions& options) const;
  SmoothingResult smooth_now(const SmoothingOptions& options);
  SmoothingResult smooth_now(const SmoothingOptions& options, std::span<const double> potential,
                             std::size_t components);
  SmoothingResult smooth_for_paper(const SmoothingOptions& options);
  void take(std::span<const SurfaceCurve> curves, const CurveOptions& options,
            const Progress& progress);
  void embed_drawn(const Progress& progress);
  void set_drawn(const CurveOptions& options, const Progress& progress);
  void forget();
  [[nodiscard]] double drawn_length() const;
  [[nodiscard]] double default_floor() const;
  void solve_distance(const Progress& progress);
  void solve_corridor(const Progress& progress);
  static DeviationMeasure measure_for(const SmoothingOptions& options);
  void make_valleys(const Progress& progress);
  void keep_valleys_apart(const Progress& progress);
  void hold_loops(const Progress& progress);
  void steepen(Corridor::Valley& valley, const SurfaceCurve& drawn) const;
  [[nodiscard]] std::vector<Corridor::Valley> valleys_for(const SmoothingOptions& options) const;
  SmoothingResult smooth_in_corridor(const SmoothingOptions& options);
  SmoothingResult smooth_in_valleys(const SmoothingOptions& options,
                                    const std::vector<Corridor::Valley>& valleys);
  SmoothingResult smooth_from_anchor(double from, const SmoothingOptions& options,
                                     const std::vector<Corridor::Valley>& valleys);
  SmoothingResult smooth_for_itself(const SmoothingOptions& options,
                                    const std::vector<Corridor::Valley>& valleys);
  // below which each tau is straightened for itself, and may lead far from the drawing
  static constexpr double kLeastAnchor = 1.0 / 8;
  struct Anchor {
    Straightened straight;               // of the anchor that it comes from
    std::vector<SurfaceCurve> rough;     // polished a little, for the next anchor below
    std::vector<SurfaceCurve> polished;  // once asked for
  };
  Straightened straighten(const SmoothingOptions& options, SignpostTriangulation::Metric metric);
  Straightened straighten_flat(const SmoothingOptions& options);
  std::optional<Straightened> unlifted(const Corridor& corridor,
                                       const std::vector<Corridor::Valley>& valleys,
                                       const SmoothingOptions& options);
  [[nodiscard]] bool is_felt(const Corridor& corridor, const Straightened& flat,
                             const Progress& progress) const;
  [[nodiscard]] double exact_for(const std::vector<Corridor::Valley>& valleys) const;
  Straightened straighten_in(const Corridor& corridor, const SmoothingOptions& options,
                             double exact);
  void hold_thin_loops(Straightened& straight) const;
  void polish_in(const Corridor& corridor, std::vector<SurfaceCurve>& curves,
                 const Progress& progress, const PolishOptions& options = {});
  static std::optional<double> anchor_of(const SmoothingOptions& options);
  Anchor& anchor_at(double tau, const SmoothingOptions& options,
                    const std::vector<Corridor::Valley>& valleys, StageTimes& times);
  SmoothingResult report_on(const SmoothingOptions& options, const Straightened& straight,
                            std::vector<SurfaceCurve> curves, StageTimes times);
  SmoothingResult run(const SmoothingOptions& options, SignpostTriangulation::Metric metric);
  // dragging.cpp
  SmoothingResult drag_now(std::size_t curve, const SurfaceCurve& moved,
                           const SmoothingOptions& options);
  SmoothingResult drag_whole(std::size_t curve, const SurfaceCurve& moved,
                             const SmoothingOptions& options);
  SmoothingResult result_for(const SmoothingOptions& options);
  [[nodiscard]] std::vector<Corridor::Valley> dragged_valleys(
      const DrawingChange& change, std::size_t curve, const SmoothingOptions& options) const;
  void set_stretch(const DragStretch& stretch, const CurveOptions& options,
                   const Progress& progress);
  SurfaceCurve rough_stretch(const SmoothingOptions& options);
  struct DragRange;
  [[nodiscard]] std::optional<DragRange> range_around(const DrawingChange& change,
                                                      double margin) const;
  std::optional<SurfaceCurve> joined(const DragRange& range, const DrawingChange& change,
                                     double margin, const SurfaceCurve& last,
                                     const SmoothingOptions& options);
  SurfaceCurve dragged(const DrawingChange& change, std::size_t curve, const SurfaceCurve& last,
                       const SmoothingOptions& options);
  void report_moves(const SmoothingOptions& options, SmoothingResult& result);

  std::shared_ptr<const OpenedMesh> mesh_;
  Straightening straightening_;
  PaperLift lift_;

  Loops loops_ = Loops::kKeep;          // kErase where strips are smoothed, and stretches
  std::unique_ptr<Unrolled> unrolled_;  // what smooths instead of this, for tangled drawings
  bool may_refine_ = true;
  bool warns_if_far_ = true;
  // And for those that are finer than the mesh, on parts of it, each with twice the reach of the
  // one before; all but the first are made when first needed.
  std::vector<std::unique_ptr<Refined>> refined_;
  OrderedDrawing drawing_;            // all that follows, "per curve", is of its curves()
  std::vector<SurfaceCurve> capped_;  // those, corners capped
  CurveOptions curve_options_;
  std::optional<PolylineDistance> exact_distance_;  // of the corridor
  std::optional<DeviationMeter> deviation_meter_;   // made when first needed
  struct Last {
    SmoothingOptions options;
    SmoothingResult result;
  };
  std::optional<Last> last_;                // of smooth() on the ordered curves
  std::unique_ptr<CurveSmoother> dragger_;  // for stretches of a drawing; made when first needed
  // Of a part of a mesh: the vertices at which it was cut off, and whether one has been touched.
  const std::vector<bool>* cut_ = nullptr;
  bool at_cut_ = false;
  std::vector<Corridor::Valley> valleys_;  // per curve, of the corridor
  std::map<double, Anchor> anchors_;       // by tau, for the valleys and the floor below
  std::vector<Corridor::Valley> anchor_valleys_;
  double anchor_floor_ = 0;
  double solve_ms_ = 0;
};

/// One curve in one call: CurveSmoother for it alone.
SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options = {},
                             const CurveOptions& curve_options = {});

/// A field on the mesh vertices as one along a drawing, for SmoothingOptions::slack_at: linear in
/// each face, at the drawing's points. Throws Error(kBadUsage) when there is not one value per
/// vertex, or one that is used is not finite and >= 0.
std::vector<double> slack_along(const Surface& surface, const SurfaceCurve& drawn,
                                std::span<const double> per_vertex);

/// A curve along mesh edges through these vertices; a list that ends with its first vertex is
/// closed. Throws Error(kBadCurve) as check_drawn does.
SurfaceCurve curve_through(const Surface& surface, std::span<const VertexId> vertices);

}  // namespace talweg

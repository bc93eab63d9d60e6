// An ordered drawing has its curves and their points in the order in which they are worked on.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/canonical_order.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/core/smoothing/smoothing_result.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The result must not depend on the end from which a curve is drawn, on where a loop begins, or on
/// the order in which the curves are listed. So everything is measured and decided on the curves in
/// canonical order, while the caller's curves and results are in the caller's order: a reversed
/// drawing has the same result to the last bit. O(n log n) for n points, times the degree of the
/// vertices they lie at.
class OrderedDrawing {
 public:
  OrderedDrawing() = default;
  /// The curves must pass check_drawn(). Throws Error(kBadCurve) for a curve without length,
  /// Cancelled.
  OrderedDrawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                 std::span<const StrokeSlack> slacks, ProgressPoller& poller);

  /// The curves as they were drawn.
  [[nodiscard]] const std::vector<SurfaceCurve>& drawn() const { return drawn_; }
  /// The curves and their points in canonical order; the numbers below refer to this order.
  [[nodiscard]] const std::vector<SurfaceCurve>& curves() const { return ordered_; }
  /// What depends on the order of the points (sign, index) is that of the curve as it was drawn.
  [[nodiscard]] const std::vector<CurveMeasures>& measures() const { return measures_; }
  /// How exact the curves are, unless somebody says otherwise.
  [[nodiscard]] const std::vector<StrokeSlack>& slacks() const { return slacks_; }
  /// The length of the mesh's edges near each curve, mesh units.
  [[nodiscard]] const std::vector<double>& edges_near() const { return edges_near_; }
  /// For each ordered curve the number of the drawn one, and (place_of()) the reverse.
  [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }
  [[nodiscard]] std::size_t place_of(std::size_t drawn) const { return places_[drawn]; }

  template <class Value>
  [[nodiscard]] std::vector<Value> in_drawn_order(const std::vector<Value>& ordered) const {
    std::vector<Value> result;
    result.reserve(places_.size());
    for (const std::size_t place : places_) result.push_back(ordered[place]);
    return result;
  }
  /// Options whose slack_at and per_curve follow the drawn curves, converted to the ordered ones.
  /// Throws Error(kBadUsage) where there are not as many values as points or curves.
  [[nodiscard]] SmoothingOptions ordered(SmoothingOptions options) const;
  /// One of the ordered curves, or its result, in the direction in which it was drawn.
  [[nodiscard]] SurfaceCurve in_drawn_direction(std::size_t ordered, SurfaceCurve curve) const;
  /// Measures of such a result, which has so many points.
  [[nodiscard]] CurveMeasures in_drawn_direction(std::size_t ordered, CurveMeasures measures,
                                                 std::size_t points) const;
  /// Measures of one of the ordered curves itself, as those of the curve that was drawn.
  [[nodiscard]] CurveMeasures of_drawn(std::size_t ordered, CurveMeasures measures) const;
  /// A result for the ordered curves, converted to the curves as they were drawn.
  [[nodiscard]] SmoothingResult as_drawn(SmoothingResult result) const;

 private:
  void order_slack(SmoothingOptions& options) const;

  std::vector<SurfaceCurve> drawn_, ordered_;
  std::vector<std::size_t> numbers_, places_;
  std::vector<CurveOrder> orders_;  // from drawn to ordered points
  std::vector<CurveMeasures> measures_;
  std::vector<StrokeSlack> slacks_;
  std::vector<double> edges_near_;
};

/// Checks curves and options. Throws as CurveSmoother::set_curves(), Cancelled.
void check_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                   const CurveOptions& options, const Progress& progress);

/// Checks curves and options and puts the curves in order. `slacks` has one entry per curve, or
/// none where nobody will ask. Throws as check_drawing().
OrderedDrawing checked_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               std::span<const StrokeSlack> slacks, const CurveOptions& options,
                               const Progress& progress);

}  // namespace talweg

// An ordered drawing has its curves and their points in canonical order.
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

/// The result must not depend on the direction of a curve, on the first point of a loop, or on the
/// order of the curves. Curves are therefore smoothed and measured in canonical order, while the
/// caller's curves and results are in drawn order; a reversed drawing has the same result to the
/// last bit. O(n log n) for n points, times the degree of their vertices.
class OrderedDrawing {
 public:
  OrderedDrawing() = default;
  /// The curves must pass check_drawn(). Throws Error(kBadCurve) for a curve without length,
  /// Cancelled.
  OrderedDrawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                 std::span<const StrokeSlack> slacks, ProgressPoller& poller);

  /// The curves in drawn order.
  [[nodiscard]] const std::vector<SurfaceCurve>& drawn() const { return drawn_; }
  /// The curves and their points in canonical order; other lists are in this order.
  [[nodiscard]] const std::vector<SurfaceCurve>& curves() const { return ordered_; }
  /// Per curve. Values that depend on the order of points (sign, index) refer to the drawn order.
  [[nodiscard]] const std::vector<CurveMeasures>& measures() const { return measures_; }
  /// Per curve, the estimated slack.
  [[nodiscard]] const std::vector<StrokeSlack>& slacks() const { return slacks_; }
  /// Per curve, edge_length_near(), mesh units.
  [[nodiscard]] const std::vector<double>& edges_near() const { return edges_near_; }
  /// Per ordered curve, the number of the drawn curve; place_of() is the inverse.
  [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }
  [[nodiscard]] std::size_t place_of(std::size_t drawn) const { return places_[drawn]; }

  template <class Value>
  [[nodiscard]] std::vector<Value> in_drawn_order(const std::vector<Value>& ordered) const {
    std::vector<Value> result;
    result.reserve(places_.size());
    for (const std::size_t place : places_) result.push_back(ordered[place]);
    return result;
  }
  /// Options with slack_at and per_curve converted from drawn to canonical order. Throws
  /// Error(kBadUsage) if the numbers of values differ from the points or curves.
  [[nodiscard]] SmoothingOptions ordered(SmoothingOptions options) const;
  /// An ordered curve or its result, in the direction of the drawn curve.
  [[nodiscard]] SurfaceCurve in_drawn_direction(std::size_t ordered, SurfaceCurve curve) const;
  /// Measures of a result with `points` points, in the direction of the drawn curve.
  [[nodiscard]] CurveMeasures in_drawn_direction(std::size_t ordered, CurveMeasures measures,
                                                 std::size_t points) const;
  /// Measures of an ordered curve, converted to the drawn curve.
  [[nodiscard]] CurveMeasures of_drawn(std::size_t ordered, CurveMeasures measures) const;
  /// A result for the ordered curves, converted to drawn order.
  [[nodiscard]] SmoothingResult as_drawn(SmoothingResult result) const;

 private:
  void order_slack(SmoothingOptions& options) const;

  std::vector<SurfaceCurve> drawn_, ordered_;
  std::vector<std::size_t> numbers_, places_;
  std::vector<CurveOrder> orders_;  // the order of points, per ordered curve
  std::vector<CurveMeasures> measures_;
  std::vector<StrokeSlack> slacks_;
  std::vector<double> edges_near_;
};

/// Checks curves and options. Throws as CurveSmoother::set_curves(), Cancelled.
void check_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                   const CurveOptions& options, const Progress& progress);

/// Checks curves and options, and orders the curves. `slacks` has one entry per curve, or is empty
/// if the slacks are not used. Throws as check_drawing().
OrderedDrawing checked_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               std::span<const StrokeSlack> slacks, const CurveOptions& options,
                               const Progress& progress);

}  // namespace talweg

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
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Who draws a curve from its other end, begins a loop elsewhere, or lists the curves otherwise,
/// means the same. So all that is measured and decided is so on curves in their canonical order,
/// and what callers give and get is in theirs: a reversed drawing has the same result to the last
/// bit.
class OrderedDrawing {
 public:
  OrderedDrawing() = default;
  /// Of curves that check_drawn() takes. Throws Error(kBadCurve) for one without length, Cancelled.
  OrderedDrawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn, Asker& asker);

  /// As they were drawn.
  [[nodiscard]] const std::vector<SurfaceCurve>& drawn() const { return drawn_; }
  /// The same in canonical order, points and curves; all that follows is by their numbers.
  [[nodiscard]] const std::vector<SurfaceCurve>& curves() const { return ordered_; }
  [[nodiscard]] const std::vector<CurveMeasures>& measures() const { return measures_; }
  /// How long the mesh's edges are near each curve.
  [[nodiscard]] const std::vector<double>& edges_near() const { return edges_near_; }
  /// Which drawn curve each is, and where each drawn curve is.
  [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }
  [[nodiscard]] std::size_t place_of(std::size_t drawn) const { return places_[drawn]; }

  template <class Value>
  [[nodiscard]] std::vector<Value> in_drawn_order(const std::vector<Value>& ordered) const {
    std::vector<Value> result;
    result.reserve(places_.size());
    for (const std::size_t place : places_) result.push_back(ordered[place]);
    return result;
  }
  /// Options whose slack_at is along the drawn curves, with it along the ordered ones. Throws
  /// Error(kBadUsage) where there are not as many values as points.
  [[nodiscard]] SmoothingOptions ordered(SmoothingOptions options) const;
  /// One of the ordered curves, or a result of it, in the direction in which it was drawn.
  [[nodiscard]] SurfaceCurve in_drawn_direction(std::size_t ordered, SurfaceCurve curve) const;
  /// A result of the ordered curves, of those as they were drawn.
  [[nodiscard]] SmoothingResult as_drawn(SmoothingResult result) const;

 private:
  std::vector<SurfaceCurve> drawn_, ordered_;
  std::vector<std::size_t> numbers_, places_;
  std::vector<CurveOrder> orders_;  // in which the points of the ordered curves are gone through
  std::vector<CurveMeasures> measures_;
  std::vector<double> edges_near_;
};

/// Checks curves and options and puts the curves in order. Throws as CurveSmoother::set_curves().
OrderedDrawing checked_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               const CurveOptions& options, const Progress& progress);

}  // namespace talweg

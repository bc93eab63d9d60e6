#include "talweg/core/smoothing/ordered_drawing.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfPoint = 8;  // units of work per point

[[noreturn]] void refuse_point(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                               std::size_t number) {
  const Point at = mesh.position(curve.points.front());
  throw Error(ErrorCode::kBadCurve,
              fmt::format("Curve {} has no length: its {} points all lie at {}, where faces "
                          "of the mesh have no extent.",
                          number, curve.points.size(), position_text(at, mesh.mean_edge_length())));
}

}  // namespace

OrderedDrawing::OrderedDrawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                               std::span<const StrokeSlack> slacks, ProgressPoller& poller)
    : drawn_(drawn.begin(), drawn.end()) {
  const Surface& surface = mesh.surface();
  std::vector<CurveOrder> orders;
  std::vector<SurfaceCurve> ordered;
  orders.reserve(drawn_.size());
  ordered.reserve(drawn_.size());
  for (const SurfaceCurve& curve : drawn_) {
    const auto next = [&] { poller.add_work(kOfPoint * curve.points.size()); };
    next();
    orders.push_back(canonical_order(mesh, curve));
    ordered.push_back(in_order(curve, orders.back()));
  }
  numbers_ = canonical_set_order(mesh, ordered);
  places_.resize(drawn_.size());
  for (const std::size_t c : numbers_) {
    places_[c] = ordered_.size();
    orders_.push_back(orders[c]);
    const SurfaceCurve& curve = ordered_.emplace_back(std::move(ordered[c]));
    slacks_.push_back(slacks.empty() ? StrokeSlack{}
                                     : talweg::in_order(slacks[c], mesh, drawn_[c], orders[c]));
    const auto next = [&] { poller.add_work(kOfPoint * curve.points.size()); };
    next();
    edges_near_.push_back(edge_length_near(surface, curve));
    next();
    measures_.push_back(of_drawn(places_[c], measure_curve(mesh, curve, edges_near_.back())));
    if (!(measures_.back().length > 0)) refuse_point(mesh, curve, c);
  }
}

CurveMeasures OrderedDrawing::of_drawn(std::size_t ordered, CurveMeasures measures) const {
  return turned_back(measures, orders_[ordered], ordered_[ordered].points.size());
}

SmoothingOptions OrderedDrawing::ordered(SmoothingOptions options) const {
  if (!options.slack_at.empty()) order_slack(options);
  if (options.per_curve.empty()) return options;
  if (options.per_curve.size() != drawn_.size()) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("per_curve has options for {} curves, not for {}.",
                            options.per_curve.size(), drawn_.size()));
  }
  const std::vector<OwnOptions> drawn = std::move(options.per_curve);
  options.per_curve.clear();
  for (const std::size_t c : numbers_) options.per_curve.push_back(drawn[c]);
  return options;
}

void OrderedDrawing::order_slack(SmoothingOptions& options) const {
  const std::vector<std::vector<double>> drawn = std::move(options.slack_at);
  if (drawn.size() != drawn_.size()) {
    throw Error(ErrorCode::kBadUsage, fmt::format("slack_at has values for {} curves, not for {}.",
                                                  drawn.size(), drawn_.size()));
  }
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    Corridor::check_slack(drawn[c], c, drawn_[c].points.size());
  }
  options.slack_at.clear();
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    const std::vector<double>& own = drawn[numbers_[c]];
    std::vector<double>& ordered = options.slack_at.emplace_back();
    ordered.reserve(own.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      ordered.push_back(own[orders_[c].drawn_index(k, own.size())]);
    }
  }
}

SurfaceCurve OrderedDrawing::in_drawn_direction(std::size_t ordered, SurfaceCurve curve) const {
  if (orders_[ordered].reversed) std::reverse(curve.points.begin(), curve.points.end());
  return curve;
}

CurveMeasures OrderedDrawing::in_drawn_direction(std::size_t ordered, CurveMeasures measures,
                                                 std::size_t points) const {
  if (!orders_[ordered].reversed) return measures;
  measures.signed_curvature = -measures.signed_curvature;
  measures.max_at = points - 1 - measures.max_at;
  return measures;
}

SmoothingResult OrderedDrawing::as_drawn(SmoothingResult result) const {
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    result.curves[c] = in_drawn_direction(c, std::move(result.curves[c]));
  }
  if (std::is_sorted(numbers_.begin(), numbers_.end())) return result;
  result.curves = in_drawn_order(result.curves);
  result.reports = in_drawn_order(result.reports);
  result.total = total_of(result.reports);
  return result;
}

void check_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                   const CurveOptions& options, const Progress& progress) {
  if (curves.empty()) throw Error(ErrorCode::kBadUsage, "There is no curve to smooth.");
  options.validate();
  ProgressPoller poller(progress, "embed");
  for (const SurfaceCurve& curve : curves) {
    poller.add_work(kOfPoint * curve.points.size());
    check_drawn(mesh.surface(), curve);
  }
  check_pins(curves, options.pins);
  check_pins(curves, options.corners, "corner");
  std::vector<SurfacePoint> exact;
  for (const WayPoint& way_point : options.way_points) exact.push_back(way_point.point);
  check_pins(curves, exact, "way-point");
  check_pins(curves, options.painted, "painted point");
}

OrderedDrawing checked_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               std::span<const StrokeSlack> slacks, const CurveOptions& options,
                               const Progress& progress) {
  check_drawing(mesh, curves, options, progress);
  ProgressPoller poller(progress, "embed");
  return {mesh, curves, slacks, poller};
}

}  // namespace talweg

#include "tools/quality/clicked_runs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "tools/quality/statistics.hpp"

namespace talweg::quality {
namespace {

constexpr std::size_t kEvery = 25;
constexpr double kLeastBending = 0.01;  // a straight curve has no ratio

struct Clicked {
  SurfaceCurve curve;
  std::vector<WayPoint> clicks;
};

std::optional<Clicked> clicked(const Surface& surface, const NamedPath& drawing) {
  std::vector<VertexId> ids;
  for (std::size_t i = 0; i < drawing.path.size(); i += kEvery) ids.push_back(drawing.path[i]);
  if (drawing.closed && drawing.path.size() % kEvery < kEvery / 2 && ids.size() > 1) {
    ids.pop_back();  // too near to the first
  }
  if (ids.size() < (drawing.closed ? 4U : 3U)) return std::nullopt;
  Clicked result;
  NamedPath path{drawing.name, {}, drawing.closed};
  try {
    path.path = draw_edge_path(surface, ids, drawing.closed);
  } catch (const Error&) {  // no path avoids the drawn part
    return std::nullopt;
  }
  result.curve = path.curve(surface);
  for (const VertexId v : ids) result.clicks.push_back({SurfacePoint::at_vertex(surface, v)});
  return result;
}

double farthest(const Surface& surface, const std::vector<SurfacePoint>& points,
                const SurfaceCurve& from) {
  PolylineDistance distance(surface);
  distance.set(std::span(&from, 1));
  double most = 0;
  for (const SurfacePoint& point : points) most = std::max(most, distance.at(point).distance);
  return most;
}

/// The stretches of a curve between consecutive clicks.
std::vector<SurfaceCurve> legs_of(const SurfaceCurve& curve, const std::vector<WayPoint>& clicks) {
  const auto is_click = [&](const SurfacePoint& point) {
    return std::any_of(clicks.begin(), clicks.end(),
                       [&](const WayPoint& click) { return click.point == point; });
  };
  std::vector<SurfacePoint> points = curve.points;
  const auto first = std::find_if(points.begin(), points.end(), is_click);
  std::rotate(points.begin(), first, points.end());
  if (curve.closed) points.push_back(points.front());
  std::vector<SurfaceCurve> legs;
  for (const SurfacePoint& point : points) {
    if (!legs.empty()) legs.back().points.push_back(point);
    if (is_click(point)) legs.push_back({false, {point}});
  }
  legs.pop_back();
  return legs;
}

double swing(const Surface& surface, const SurfaceCurve& result, const SurfaceCurve& straight,
             const std::vector<WayPoint>& clicks) {
  const std::vector<SurfaceCurve> legs = legs_of(straight, clicks), own = legs_of(result, clicks);
  if (legs.size() != own.size()) return HUGE_VAL;
  const std::size_t n = legs.size();
  std::vector<double> lengths;
  lengths.reserve(n);
  for (const SurfaceCurve& leg : legs) lengths.push_back(curve_length(surface, leg));
  double most = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double shortest = lengths[k];
    if (result.closed || k > 0) shortest = std::min(shortest, lengths[(k + n - 1) % n]);
    if (result.closed || k + 1 < n) shortest = std::min(shortest, lengths[(k + 1) % n]);
    most = std::max(most, farthest(surface, own[k].points, straight) / shortest);
  }
  return most;
}

ClickedRun measured(const Subject& subject, const NamedPath& drawing, const Clicked& drawn) {
  const Surface& surface = subject.mesh->surface();
  const double edge = edge_length_near(surface, drawn.curve);
  CurveOptions exact;
  exact.way_points = drawn.clicks;
  SmoothingOptions options;
  options.deviation = DeviationMeasure::kNone;
  CurveSmoother smoother(subject.mesh);
  const Stopwatch watch;
  smoother.set_curve(drawn.curve, exact);
  const SmoothingResult result = smoother.smooth(options);
  ClickedRun run{subject.name, drawing.name, drawn.clicks.size()};
  run.ms = watch.ms();
  run.warned = !result.total.warnings.empty();
  SmoothingOptions none = options, taut = options;
  none.tau = 0;
  taut.finish = Finish::kTaut;
  const SurfaceCurve straight = smoother.smooth(none).curve();
  smoother.set_curve(drawn.curve);
  const CurveMeasures own = measure_curve(surface, result.curve(), edge);
  const CurveMeasures rough = measure_curve(surface, smoother.smooth(taut).curve(), edge);
  const double legs = curve_length(surface, straight);
  run.leg = legs / edge / static_cast<double>(drawn.clicks.size() - (drawing.closed ? 0 : 1));
  run.longer = own.length / legs;
  run.bending = own.bending / std::max(rough.bending, kLeastBending);
  run.window_turning = own.window_turning;
  run.largest_turn = own.max_curvature;
  run.swing = swing(surface, result.curve(), straight, drawn.clicks);
  std::vector<SurfacePoint> clicks;
  for (const WayPoint& click : drawn.clicks) clicks.push_back(click.point);
  run.missed = farthest(surface, clicks, result.curve()) / edge;
  exact.way_points.push_back({result.curve().points[result.curve().points.size() / 2]});
  smoother.set_curve(result.curve(), exact);
  run.inserted = farthest(surface, smoother.smooth(options).curve().points, result.curve()) / edge;
  return run;
}

std::string row(const std::string& name, std::span<const ClickedRun> runs) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const auto median_and_worst = [&](double ClickedRun::*value, double unit, const char* format) {
    std::vector<double> values;
    for (const ClickedRun& run : runs) values.push_back(unit * (run.*value));
    return fmt::format(fmt::runtime(format), quantile(values, 0.5), quantile(values, 1));
  };
  const auto warned =
      std::count_if(runs.begin(), runs.end(), [](const auto& r) { return r.warned; });
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, runs.size(),
                     median_and_worst(&ClickedRun::bending, 1, "{:.3f} | {:.2f}"),
                     median_and_worst(&ClickedRun::window_turning, kDegrees, "{:.0f} | {:.0f}"),
                     median_and_worst(&ClickedRun::largest_turn, kDegrees, "{:.1f} | {:.1f}"),
                     median_and_worst(&ClickedRun::swing, 1, "{:.2f} | {:.2f}"),
                     median_and_worst(&ClickedRun::longer, 1, "{:.3f} | {:.3f}"),
                     median_and_worst(&ClickedRun::inserted, 1, "{:.2f} | {:.2f}"),
                     median_and_worst(&ClickedRun::ms, 1, "{:.0f} | {:.0f}"), warned);
}

}  // namespace

std::string tables(std::span<const ClickedRun> runs) {
  std::string text =
      "| | runs | bending / bending of the taut curve, median | worst | turn in one h₀ [°] | worst "
      "| largest turn at one point [°] | worst | largest distance from the legs / length of the "
      "shorter adjacent leg | worst | length / length of the legs | worst | movement by an "
      "inserted click [h₀] | worst | time [ms] | worst | warned |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t j = i;
    while (j < runs.size() && runs[j].mesh == runs[i].mesh) ++j;
    text += row(runs[i].mesh, runs.subspan(i, j - i));
    i = j;
  }
  return text + row("all", runs);
}

std::vector<ClickedRun> clicked_runs(const Subject& subject) {
  std::vector<ClickedRun> runs;
  for (const NamedPath& drawing : subject.drawings) {
    const std::optional<Clicked> drawn = clicked(subject.mesh->surface(), drawing);
    if (drawn) runs.push_back(measured(subject, drawing, *drawn));
  }
  return runs;
}

}  // namespace talweg::quality

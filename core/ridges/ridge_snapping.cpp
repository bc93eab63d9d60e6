#include "talweg/core/ridges/ridge_snapping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/smooth_ground.hpp"
#include "talweg/core/ridges/ridge_gates.hpp"
#include "talweg/core/ridges/ridge_way.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

/// The points that stay: fixed points, and points that curves have in common.
PointLookup points_that_stay(std::span<const SurfaceCurve> curves,
                             std::span<const SurfacePoint> fixed) {
  PointLookup stay(fixed), met;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      if (met.contains(point)) stay.add(point);
      met.add(point);
    }
  }
  return stay;
}

double largest_distance(std::span<const Point> from, std::span<const Point> to) {
  const NearestSegment nearest(segments_of(to, false));
  double largest = 0;
  for (const Point& point : from) largest = std::max(largest, nearest.to(point).distance);
  return largest;
}

/// Joins a curve with its way along ridges: where the way leaves the drawing for a ridge, the way
/// replaces the drawing; elsewhere the drawing stays.
class Departures {
 public:
  Departures(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::vector<RidgeStep> way)
      : mesh_(&mesh), curve_(&curve), way_(std::move(way)) {}

  SurfaceCurve run(RidgeMoves& moves) {
    if (curve_->closed) begin_on_drawing();
    SurfaceCurve result{curve_->closed, {}};
    const std::size_t n = way_.size(), all = curve_->closed ? n + 1 : n;
    std::size_t from = 0;
    if (!way_.front().drawn || (!curve_->closed && *way_.front().drawn != 0)) {
      from = next_drawn(0, all);
      leave({}, 0, from, result, moves);
    }
    while (from < all) {
      add(way_[from % n], result);
      const std::size_t next = next_drawn(from + 1, all);
      if (next >= all) {
        if (is_end(from) || curve_->closed) break;
        leave(from, from, all, result, moves);
        break;
      }
      leave(from, from, next, result, moves);
      from = next;
    }
    if (curve_->closed && result.points.size() > 1 &&
        result.points.front() == result.points.back()) {
      result.points.pop_back();
    }
    const double length = curve_length(mesh_->surface(), *curve_);
    moves.moved = std::min(1.0, left_ / length);
    moves.already = std::min(1.0, stayed_ / length);
    return result;
  }

  /// The points of the result that are not in the drawing.
  [[nodiscard]] const std::vector<SurfacePoint>& made() const { return made_; }
  /// The new place of the gate's point; null if the point stays.
  [[nodiscard]] const SurfacePoint* moved_to(std::size_t gate) const {
    const auto there = moved_.find(gate);
    return there == moved_.end() ? nullptr : &there->second;
  }

 private:
  void begin_on_drawing() {
    const auto first = std::find_if(way_.begin(), way_.end(),
                                    [](const RidgeStep& step) { return step.drawn.has_value(); });
    std::rotate(way_.begin(), first == way_.end() ? way_.begin() : first, way_.end());
  }
  [[nodiscard]] std::size_t next_drawn(std::size_t from, std::size_t all) const {
    while (from < all && !way_[from % way_.size()].drawn) ++from;
    return from;
  }
  [[nodiscard]] bool is_end(std::size_t step) const {
    return way_[step].drawn && *way_[step].drawn + 1 == curve_->points.size();
  }
  static void add(const RidgeStep& step, SurfaceCurve& result) {
    if (result.points.empty() || !(result.points.back() == step.point)) {
      result.points.push_back(step.point);
    }
  }

  /// The drawn points between two steps, including the points of the steps.
  [[nodiscard]] std::vector<SurfacePoint> drawn_between(std::optional<std::size_t> from,
                                                        std::size_t to) const {
    const std::size_t n = curve_->points.size(), all = way_.size() + (curve_->closed ? 1 : 0);
    std::size_t a = from ? *way_[*from % way_.size()].drawn : 0;
    std::size_t b = to < all ? *way_[to % way_.size()].drawn : n - 1;
    if (curve_->closed && (b < a || (b == a && to - *from >= way_.size()))) b += n;
    if (!from && to >= all && curve_->closed) b = n;
    std::vector<SurfacePoint> points;
    if (b < a) return points;  // the way runs backwards
    for (std::size_t i = a; i <= b; ++i) points.push_back(curve_->points[i % n]);
    return points;
  }

  /// Whether a ridge lies under at least half of the way between two steps.
  [[nodiscard]] bool is_on_ridge(std::size_t begin, std::size_t end) const {
    double whole = 0, on = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const RidgeStep& step = way_[k % way_.size()];
      const double length = distance(step.point, way_[(k + 1) % way_.size()].point);
      whole += length;
      if (step.ridge_next) on += length;
    }
    return whole > 0 && on >= whole / 2;
  }

  /// Adds the points between two steps on the drawing, or between such a step and an end of the
  /// curve: points of the way if a ridge lies under it, else points of the drawing.
  void leave(std::optional<std::size_t> from, std::size_t begin, std::size_t end,
             SurfaceCurve& result, RidgeMoves& moves) {
    const std::size_t all = way_.size() + (curve_->closed ? 1 : 0);
    const std::vector<SurfacePoint> drawn = drawn_between(from, end);
    const bool is_drawn = end == begin + 1 && drawn.size() == 2;
    const std::size_t last = std::min(end, all - 1);
    if (is_drawn) {
      if (way_[begin % way_.size()].ridge_next) stayed_ += distance(drawn.front(), drawn.back());
      return;
    }
    if (!drawn.empty() && !is_on_ridge(begin, last)) {
      for (const SurfacePoint& point : drawn) add({point, {}, {}, false}, result);
      return;
    }
    std::vector<Point> places, before;
    for (std::size_t k = begin; k <= last; ++k) {
      const RidgeStep& step = way_[k % way_.size()];
      places.push_back(mesh_->position(step.point));
      if (step.drawn) continue;
      add(step, result);
      made_.push_back(step.point);
      if (step.gate) moved_.insert_or_assign(*step.gate, step.point);
    }
    for (const SurfacePoint& point : drawn) before.push_back(mesh_->position(point));
    if (before.empty() || places.empty()) return;
    const double off = std::max(largest_distance(places, before), largest_distance(before, places));
    const bool has_moved = off > kRounding * moves.band;
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      (has_moved ? left_ : stayed_) += (before[i + 1] - before[i]).norm();
    }
    if (has_moved) moves.farthest = std::max(moves.farthest, off);
  }

  [[nodiscard]] double distance(const SurfacePoint& from, const SurfacePoint& to) const {
    return (mesh_->position(from) - mesh_->position(to)).norm();
  }

  // A fraction of the band. A way that stays this near to the drawing is not a move.
  static constexpr double kRounding = 1e-6;

  const SurfaceMesh* mesh_;
  const SurfaceCurve* curve_;
  std::vector<RidgeStep> way_;
  std::vector<SurfacePoint> made_;
  std::unordered_map<std::size_t, SurfacePoint> moved_;  // only looked up
  double left_ = 0, stayed_ = 0;  // lengths of the drawing that moved onto ridges, or lay there
};

/// The largest distance at which a ridge attracts the drawing. A click moves at most a third of the
/// way to the next click, so dense clicks hold a curve whose points were all clicked.
double reach_of(const RidgeGates& gates, double band) {
  double reach = 0;
  for (const RidgeGate& gate : gates.gates) reach = std::max(reach, gate.radius);
  return reach > 0 ? std::min(reach, band) : band;
}

/// The lengths by which one curve is snapped.
struct Setting {
  RidgeBand band;
  double scale = 0, roughness = 0;
};

Setting setting_of(const SurfaceMesh& mesh, const SurfaceCurve& curve, const RidgeOptions& options,
                   const Progress& progress) {
  constexpr double kOfLength = 1.0 / 40, kMostOfLength = 1.0 / 4, kLeast = 4, kMost = 12;
  constexpr double kLegPart = 1.0 / 4, kLegEdges = 40;
  constexpr double kScale = 3, kOfRoughness = 10, kOfBand = 1.0 / 3, kMostOfBand = 4;
  const double edge = edge_length_near(mesh.surface(), curve);
  const double length = curve_length(mesh.surface(), curve);
  Setting setting;
  if (options.band) {
    setting.band = {*options.band, 0, 0, edge};
  } else {
    const double band = std::clamp(kOfLength * length, kLeast * edge, kMost * edge);
    setting.band = {std::min(band, kMostOfLength * length), kLegPart, kLegEdges * edge, edge};
  }
  setting.roughness = roughness_along(mesh, std::span(&curve, 1), progress);
  setting.scale = std::max((kScale + kOfRoughness * setting.roughness) * edge,
                           std::min(kOfBand * setting.band.width, kMostOfBand * edge));
  return setting;
}

/// Snaps the curves of a drawing, one after another.
class Snapping {
 public:
  Snapping(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
           std::span<const SurfacePoint> fixed, MarkedPoints points, const RidgeOptions& options,
           const Progress& progress)
      : mesh_(&mesh),
        stay_(points_that_stay(curves, fixed)),
        options_(options),
        progress_(progress),
        poller_(progress, "draw") {
    result_.curves.assign(curves.begin(), curves.end());
    result_.points = std::move(points);
  }

  RidgedDrawing run() {
    const MarkedPoints given = result_.points;
    for (std::size_t c = 0; c < result_.curves.size(); ++c) {
      poller_.set_fraction(static_cast<double>(c) / static_cast<double>(result_.curves.size()));
      move(c, given);
    }
    drop_painted_points_off_the_curves();
    return std::move(result_);
  }

 private:
  void move(std::size_t c, const MarkedPoints& given) {
    SurfaceCurve& curve = result_.curves[c];
    const Setting setting = setting_of(*mesh_, curve, options_, progress_);
    const RidgeGates gates =
        ridge_gates(*mesh_, curve, stay_, given.way_points, given.painted, setting.band);
    RidgeMoves moves;
    moves.strength = options_.strength;
    moves.band = setting.band.width;
    moves.reach = reach_of(gates, setting.band.width);
    moves.scale = setting.scale;
    RidgeField field(*mesh_, options_.kind, setting.scale, setting.roughness);
    Departures departures(*mesh_, curve,
                          ridge_way(*mesh_, field, curve, gates, options_.strength, poller_));
    SurfaceCurve moved = departures.run(moves);
    if (is_curve(moved) && !departures.made().empty()) {
      move_way_points(curve, gates, departures, moves);
      if (has_way_points(moved)) {
        std::vector<SurfacePoint>& painted = result_.points.painted;
        painted.insert(painted.end(), departures.made().begin(), departures.made().end());
      }
      curve = std::move(moved);
    } else {
      moves.moved = moves.farthest = 0;
    }
    result_.moves.push_back(moves);
  }

  /// Drops painted points that lie on no curve any more.
  void drop_painted_points_off_the_curves() {
    if (result_.points.painted.empty()) return;
    PointLookup points;
    for (const SurfaceCurve& curve : result_.curves) points.add_all(curve.points);
    std::erase_if(result_.points.painted,
                  [&](const SurfacePoint& point) { return !points.contains(point); });
  }

  /// Whether the points suffice for a curve. The way of a small loop may collapse onto one place.
  [[nodiscard]] static bool is_curve(const SurfaceCurve& curve) {
    return curve.points.size() >= (curve.closed ? 3U : 2U);
  }

  void move_way_points(const SurfaceCurve& curve, const RidgeGates& gates,
                       const Departures& departures, RidgeMoves& moves) {
    for (std::size_t g = 0; g < gates.gates.size(); ++g) {
      const SurfacePoint* to = departures.moved_to(g);
      if (!gates.gates[g].is_click || to == nullptr) continue;
      const SurfacePoint& from = curve.points[gates.gates[g].point];
      for (WayPoint& way : result_.points.way_points) {
        if (way.point == from) way.point = *to;
      }
      ++moves.clicks;
      moves.farthest_click =
          std::max(moves.farthest_click, (mesh_->position(from) - mesh_->position(*to)).norm());
    }
  }

  [[nodiscard]] bool has_way_points(const SurfaceCurve& curve) const {
    const PointLookup points(curve.points);
    return std::any_of(result_.points.way_points.begin(), result_.points.way_points.end(),
                       [&](const WayPoint& way) { return points.contains(way.point); });
  }

  const SurfaceMesh* mesh_;
  PointLookup stay_;
  RidgeOptions options_;
  Progress progress_;
  ProgressPoller poller_;
  RidgedDrawing result_;
};

}  // namespace

void RidgeOptions::validate() const {
  if (!(strength >= 0 && strength <= 1)) {
    throw Error(ErrorCode::kBadUsage, "The strength of ridges must be between 0 and 1.");
  }
  if (band && !(*band > 0 && std::isfinite(*band))) {
    throw Error(ErrorCode::kBadUsage, "The band around ridges must be finite and above 0.");
  }
}

std::string RidgeMoves::sentence(std::size_t curve) const {
  const double seen = 0.005;  // smaller parts would be written as 0 %
  if (moved == 0 && already >= seen) {
    return fmt::format(
        "{:.0f} % of curve {} lie on ridges as they were drawn; nothing had to be moved (band "
        "{:.3g}, strength {:g}).",
        100 * already, curve, band, strength);
  }
  if (moved == 0) {
    return fmt::format(
        "Curve {} stays as it was drawn: no ridge that is strong enough lies within {} of it.",
        curve, mesh_units_text(reach));
  }
  std::string text = fmt::format(
      "{:.0f} % of curve {} were moved onto ridges, by up to {} (band {:.3g}, "
      "strength {:g}).",
      100 * moved, curve, mesh_units_text(farthest), band, strength);
  if (already >= seen) text += fmt::format(" {:.0f} % lay on ridges already.", 100 * already);
  if (clicks > 0) {
    text += fmt::format(" {} of its clicks moved, too, by up to {:.3g}.", clicks, farthest_click);
  }
  return text;
}

std::vector<ReportEntry> entries_of(const RidgeMoves& moves) {
  return {{"ridge_strength", moves.strength},
          {"ridge_band", moves.band},
          {"ridge_moved", moves.moved},
          {"ridge_moved_max", moves.farthest},
          {"ridge_already", moves.already},
          {"ridge_clicks_moved", std::uint64_t{moves.clicks}},
          {"ridge_clicks_moved_max", moves.farthest_click}};
}

std::vector<ReportEntry> total_entries(std::span<const RidgeMoves> moves) {
  if (moves.empty()) return {};
  RidgeMoves most = moves.front();
  for (const RidgeMoves& curve : moves.subspan(1)) {
    most.band = std::max(most.band, curve.band);
    most.moved = std::max(most.moved, curve.moved);
    most.already = std::max(most.already, curve.already);
    most.farthest = std::max(most.farthest, curve.farthest);
    most.clicks += curve.clicks;
    most.farthest_click = std::max(most.farthest_click, curve.farthest_click);
  }
  return entries_of(most);
}

RidgedDrawing snapped_to_ridges(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfacePoint> fixed, MarkedPoints points,
                                const RidgeOptions& options, const Progress& progress) {
  options.validate();
  if (options.strength == 0) {
    return {{curves.begin(), curves.end()}, std::move(points), {}};
  }
  return Snapping(mesh, curves, fixed, std::move(points), options, progress).run();
}

}  // namespace talweg

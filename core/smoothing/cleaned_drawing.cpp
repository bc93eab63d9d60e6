#include "talweg/core/smoothing/cleaned_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/canonical_order.hpp"
#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/smoothing/smoothing_report.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/strokes/stroke_cleaning.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

std::string note_on(const CleanedStroke& stroke) {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
  };
  add(stroke.rests, "place where the hand rested", "places where the hand rested");
  add(stroke.hooks, "hook at an end", "hooks at the ends");
  return fmt::format("Left out of the drawing: {}, up to {} from the rest of the drawing.",
                     fmt::join(parts, " and "), mesh_units_text(stroke.farthest));
}

/// Cleans one curve, given in its canonical order.
class CurveCleaning {
 public:
  CurveCleaning(const SurfaceMesh& mesh, SurfaceCurve curve, const CurveOptions& options,
                std::span<const SurfacePoint> dropped, std::vector<SurfacePoint>& painted)
      : dropped_(dropped),
        any_dropped_(!dropped.empty()),
        mesh_(&mesh),
        curve_(std::move(curve)),
        painted_points_(options.painted),
        painted_(&painted) {
    PointLookup fixed(options.pins);
    fixed.add_all(options.corners);
    for (const WayPoint& way : options.way_points) fixed.add(way.point);
    for (std::size_t i = 0; i < curve_.points.size(); ++i) {
      if (fixed.contains(curve_.points[i])) fixed_.push_back(i);
    }
    std::vector<SurfacePoint> pins = options.pins;
    pins.insert(pins.end(), options.corners.begin(), options.corners.end());
    legs_ = legs_of(curve_, pins, options.way_points, options.painted);
  }

  CleanedCurve run(const StrokeSlack* known) {
    CleanedCurve result;
    result.curve = curve_;
    result.slack = known != nullptr ? *known : slack();
    const bool trembles = result.slack.source == SlackSource::kTrembling;
    if (legs_.all() && !any_dropped_) return result;
    trembling_ = trembles ? result.slack.slack : 0;
    if (fixed_.empty() && curve_.closed) {
      result.curve.points.clear();
      append(cleaned_stroke(*mesh_, curve_, trembling_), curve_, 0, result);
    } else {
      clean_stretches(result);
    }
    if (!any_) {
      result.curve = curve_;
      result.places.clear();
      return result;
    }
    result.farthest = sum_.farthest;
    result.left_out = curve_.points.size() - kept_;
    result.measures =
        measure_curve(*mesh_, curve_, edge_length_near(mesh_->surface(), result.curve));
    if (sum_.rests + sum_.hooks > 0) result.notes.push_back(note_on(sum_));
    return result;
  }

 private:
  [[nodiscard]] StrokeSlack slack() const {
    const double edge = edge_length_near(mesh_->surface(), curve_);
    if (legs_.all()) {
      return {slack_of_segments(mesh_->surface(), curve_), SlackSource::kSegments, {}};
    }
    StrokeSlack slack = stroke_slack(*mesh_, strokes_of(legs_, curve_), edge);
    if (legs_.any()) slack.along.clear();
    return slack;
  }

  void clean_stretches(CleanedCurve& result) {
    const std::size_t n = curve_.points.size();
    std::vector<std::size_t> ends = fixed_;
    if (curve_.closed) {
      ends.push_back(fixed_.front() + n);
    } else {
      if (ends.empty() || ends.front() != 0) ends.insert(ends.begin(), 0);
      if (ends.back() != n - 1) ends.push_back(n - 1);
    }
    const std::vector<bool> strokes = on_strokes(legs_, curve_);
    result.curve.points.clear();
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      SurfaceCurve stretch;
      for (std::size_t i = ends[k]; i <= ends[k + 1]; ++i) {
        stretch.points.push_back(curve_.points[i % n]);
      }
      const bool is_stroke = ends[k] + 1 < ends[k + 1] && strokes[(ends[k] + 1) % n];
      append(is_stroke ? cleaned(stretch, {is_free(ends[k]), is_free(ends[k + 1])}) : leg(stretch),
             stretch, ends[k], result);
      if (k + 2 < ends.size() || curve_.closed) {  // the next stretch repeats the point
        result.curve.points.pop_back();
        result.places.pop_back();
        --kept_;
      }
    }
  }

  /// A leg, made straight if it leads through a dropped click.
  [[nodiscard]] CleanedStroke leg(const SurfaceCurve& stretch) const {
    const bool leads_through =
        std::any_of(stretch.points.begin(), stretch.points.end(),
                    [&](const SurfacePoint& point) { return dropped_.contains(point); });
    if (leads_through) {
      if (auto line = straight_line_along(mesh_->surface(), stretch)) return *std::move(line);
    }
    return {stretch, {}};
  }

  /// Whether an end of an open curve may be cut off. An end on the boundary, where the drawing left
  /// the mesh, stays.
  [[nodiscard]] bool is_free(std::size_t end) const {
    return !curve_.closed && !std::binary_search(fixed_.begin(), fixed_.end(), end) &&
           !is_on_boundary(mesh_->surface(), curve_.points[end % curve_.points.size()]);
  }

  [[nodiscard]] CleanedStroke cleaned(const SurfaceCurve& stretch, FreeEnds ends) const {
    CleanedStroke stroke = cleaned_stroke(*mesh_, stretch, trembling_, ends);
    if (stroke.curve.points.size() < 3)
      return {stretch, {}};  // a stretch needs an inner point that can be painted
    return stroke;
  }

  void append(CleanedStroke stroke, const SurfaceCurve& given, std::size_t first,
              CleanedCurve& result) {
    any_ = any_ || stroke.is_cleaned();
    if (stroke.is_cleaned()) keep_painted(stroke, given);
    for (std::size_t i = 0; i < stroke.curve.points.size(); ++i) {
      result.curve.points.push_back(stroke.curve.points[i]);
      const double place = stroke.is_cleaned() ? stroke.places[i] : static_cast<double>(i);
      result.places.push_back(static_cast<double>(first) + place);
      kept_ += static_cast<std::size_t>(place == std::floor(place));
    }
    sum_.rests += stroke.rests;
    sum_.hooks += stroke.hooks;
    sum_.farthest = std::max(sum_.farthest, stroke.farthest);
  }

  /// Marks an inner point of a cleaned stretch as painted if the given stretch had a painted point.
  void keep_painted(const CleanedStroke& stroke, const SurfaceCurve& given) {
    if (painted_points_.empty()) return;
    const PointLookup painted(painted_points_);
    const bool any = std::any_of(given.points.begin(), given.points.end(),
                                 [&](const SurfacePoint& p) { return painted.contains(p); });
    if (any) painted_->push_back(stroke.curve.points[1]);
  }

  PointLookup dropped_;  // clicks that were merged with others
  bool any_dropped_;
  const SurfaceMesh* mesh_;
  SurfaceCurve curve_;
  std::span<const SurfacePoint> painted_points_;
  std::vector<SurfacePoint>* painted_;
  std::vector<std::size_t> fixed_;
  DrawnLegs legs_;
  double trembling_ = 0;
  bool any_ = false;
  std::size_t kept_ = 0;  // number of given points that are kept
  CleanedStroke sum_;
};

/// Converts a curve that was cleaned in canonical order to the direction in which it was drawn.
void turn_back(const CurveOrder& order, std::size_t given_points, CleanedCurve& curve) {
  const auto n = static_cast<double>(given_points), start = static_cast<double>(order.start);
  for (double& place : curve.places) {
    place = order.reversed ? start - place : start + place;
    if (place < 0) place += n;
    if (place >= n) place -= n;
  }
  curve.measures = turned_back(curve.measures, order, given_points);
  if (!order.reversed) return;
  std::reverse(curve.curve.points.begin(), curve.curve.points.end());
  std::reverse(curve.places.begin(), curve.places.end());
}

std::vector<SurfacePoint> painted_left(std::span<const CleanedCurve> curves,
                                       std::span<const SurfacePoint> painted,
                                       std::vector<SurfacePoint> more) {
  if (painted.empty()) return {};
  PointLookup left;
  for (const CleanedCurve& curve : curves) left.add_all(curve.curve.points);
  for (const SurfacePoint& point : painted) {
    if (left.contains(point)) more.push_back(point);
  }
  return more;
}

}  // namespace

std::vector<double> CleanedCurve::values(std::span<const double> given, bool closed) const {
  if (places.empty()) return {given.begin(), given.end()};
  std::vector<double> values;
  for (const double place : places) {
    const auto k = std::min(static_cast<std::size_t>(place), given.size() - 1);
    const std::size_t next = k + 1 < given.size() ? k + 1 : closed ? 0 : k;
    const double part = place - static_cast<double>(k);
    values.push_back((1 - part) * given[k] + part * given[next]);
  }
  return values;
}

std::vector<SurfaceCurve> CleanedDrawing::drawn() const {
  std::vector<SurfaceCurve> drawn;
  for (const CleanedCurve& curve : curves) drawn.push_back(curve.curve);
  return drawn;
}

std::vector<StrokeSlack> CleanedDrawing::slacks() const {
  std::vector<StrokeSlack> slacks;
  for (const CleanedCurve& curve : curves) slacks.push_back(curve.slack);
  return slacks;
}

bool is_same(const CleanedDrawing& a, const CleanedDrawing& b) {
  const auto same_curve = [](const CleanedCurve& one, const CleanedCurve& other) {
    return one.curve.points == other.curve.points && one.places == other.places &&
           one.slack.slack == other.slack.slack && one.slack.source == other.slack.source &&
           one.slack.along == other.slack.along && one.notes == other.notes;
  };
  const auto same_way = [](const WayPoint& one, const WayPoint& other) {
    return one.point == other.point && one.tolerance == other.tolerance;
  };
  const auto same = [](const auto& one, const auto& other, const auto& is_alike) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), is_alike);
  };
  return a.painted == b.painted && same(a.curves, b.curves, same_curve) &&
         same(a.way_points, b.way_points, same_way);
}

void report_cleaning(const CleanedCurve& curve, const SurfaceCurve& given,
                     const SurfaceMesh* ground, SmoothingReport& report) {
  report.warnings.insert(report.warnings.end(), curve.notes.begin(), curve.notes.end());
  if (curve.places.empty()) return;
  report.points_before = given.points.size();
  report.left_out = curve.left_out;
  report.left_out_max = curve.farthest;
  report.before = ground == nullptr
                      ? curve.measures
                      : turns_on_ground(*ground, given, report.edge_length_near, curve.measures);
}

namespace {

/// Finds the clicks of one curve, in canonical order, that are merged with the previous click.
class NearClicks {
 public:
  /// `often`: points that curves pass more than once; clicks there stay.
  NearClicks(const SurfaceMesh& mesh, const SurfaceCurve& curve, const CurveOptions& options,
             const PointLookup& often)
      : mesh_(&mesh), curve_(&curve), often_(&often), arcs_{0} {
    PointLookup ways;
    for (const WayPoint& way : options.way_points) ways.add(way.point);
    const std::size_t n = curve.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (ways.contains(curve.points[i])) clicks_.push_back(i);
      const Point to = mesh.position(curve.points[(i + 1) % n]);
      arcs_.push_back(arcs_.back() + (to - mesh.position(curve.points[i])).norm());
    }
    if (clicks_.size() <= fewest()) return;
    distance_ = options.click_distance.value_or(usual_distance());
  }

  /// The clicks to drop. Of consecutive near clicks the first stays, and the ends of an open curve
  /// stay.
  [[nodiscard]] std::vector<SurfacePoint> dropped() {
    std::vector<SurfacePoint> dropped;
    if (clicks_.size() <= fewest() || !(distance_ > 0)) return dropped;
    const std::size_t n = curve_->points.size();
    std::size_t left = clicks_.size(), last = clicks_.front();
    for (std::size_t k = 1; k < clicks_.size() && left > fewest(); ++k) {
      const std::size_t here = clicks_[k];
      const bool is_last = k + 1 == clicks_.size();
      double gap = between(last, here);
      if (curve_->closed && is_last) {
        gap = std::min(gap, between(here, curve_->points.size() + clicks_.front()));
      }
      if (gap > distance_) {
        last = here;
        continue;
      }
      const bool is_end = !curve_->closed && here + 1 == n;
      const std::size_t drop = is_end ? last : here;
      if (drop == 0 && !curve_->closed) break;
      if (often_->contains(curve_->points[drop])) {
        last = here;
        continue;
      }
      dropped.push_back(curve_->points[drop]);
      farthest_ = std::max(farthest_, gap);
      --left;
      if (is_end) last = here;
    }
    return dropped;
  }
  [[nodiscard]] double farthest() const { return farthest_; }

 private:
  /// A spline needs two clicks, a closed spline three.
  [[nodiscard]] std::size_t fewest() const { return curve_->closed ? 3 : 2; }
  /// The distance along the drawing from point a to point b. Distances in space would merge clicks
  /// where the drawing comes back. For a loop, b may be a point of the next round.
  [[nodiscard]] double between(std::size_t a, std::size_t b) const {
    const std::size_t n = curve_->points.size();
    return b < n ? arcs_[b] - arcs_[a] : arcs_[n] - arcs_[a] + arcs_[b - n];
  }
  [[nodiscard]] double usual_distance() const {
    constexpr double kOfEdge = 1.05, kOfMedian = 0.25;
    std::vector<double> gaps;
    for (std::size_t k = 0; k + (curve_->closed ? 0 : 1) < clicks_.size(); ++k) {
      const bool is_last = k + 1 == clicks_.size();
      const std::size_t next = is_last ? curve_->points.size() + clicks_[0] : clicks_[k + 1];
      gaps.push_back(between(clicks_[k], next));
    }
    const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
    std::nth_element(gaps.begin(), middle, gaps.end());
    return std::min(kOfEdge * edge_length_near(mesh_->surface(), *curve_), kOfMedian * *middle);
  }

  const SurfaceMesh* mesh_;
  const SurfaceCurve* curve_;
  const PointLookup* often_;
  std::vector<double> arcs_;  // arc length of each point; then of a whole loop
  std::vector<std::size_t> clicks_;
  double distance_ = 0, farthest_ = 0;
};

/// Removes merged clicks of a curve from the options. Returns them, with a sentence for the user.
std::vector<SurfacePoint> merge_clicks(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                                       const PointLookup& often, CurveOptions& options,
                                       std::vector<std::string>& notes) {
  NearClicks clicks(mesh, curve, options, often);
  std::vector<SurfacePoint> dropped = clicks.dropped();
  if (dropped.empty()) return dropped;
  const PointLookup gone(dropped);
  std::erase_if(options.way_points, [&](const WayPoint& way) { return gone.contains(way.point); });
  notes.push_back(
      fmt::format("{} of the points that the result should pass {} within {} of "
                  "another point and {} merged with that point.",
                  dropped.size(), dropped.size() == 1 ? "lies" : "lie",
                  mesh_units_text(clicks.farthest()), dropped.size() == 1 ? "was" : "were"));
  return dropped;
}

/// The points that curves pass more than once.
PointLookup points_passed_often(std::span<const SurfaceCurve> curves) {
  PointLookup once, often;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) (once.contains(point) ? often : once).add(point);
  }
  return often;
}

}  // namespace

CleanedDrawing cleaned_drawing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> given,
                               const CurveOptions& options, std::span<const StrokeSlack> known,
                               const Progress& progress) {
  constexpr std::size_t kOfPoint = 32;  // units of work
  ProgressPoller poller(progress, "embed");
  CleanedDrawing cleaned;
  std::vector<SurfacePoint> painted;
  CurveOptions merged = options;
  const PointLookup often = points_passed_often(given);
  for (std::size_t c = 0; c < given.size(); ++c) {
    const SurfaceCurve& curve = given[c];
    poller.add_work(kOfPoint * curve.points.size());
    if (options.method == Method::kPaper) {
      cleaned.curves.emplace_back().curve = curve;
      continue;
    }
    const CurveOrder order = canonical_order(mesh, curve);
    const SurfaceCurve ordered = in_order(curve, order);
    std::vector<std::string> notes;
    const std::vector<SurfacePoint> dropped = merge_clicks(mesh, ordered, often, merged, notes);
    CleanedCurve& own =
        cleaned.curves.emplace_back(CurveCleaning(mesh, ordered, merged, dropped, painted)
                                        .run(known.empty() ? nullptr : &known[c]));
    own.notes.insert(own.notes.begin(), notes.begin(), notes.end());
    if (known.empty() && !own.slack.along.empty()) {
      own.slack = turned_back(own.slack, mesh, curve, order);
    }
    if (own.places.empty()) {
      own.curve = curve;
    } else {
      turn_back(order, curve.points.size(), own);
    }
  }
  cleaned.way_points = std::move(merged.way_points);
  cleaned.painted = painted_left(cleaned.curves, options.painted, std::move(painted));
  return cleaned;
}

}  // namespace talweg

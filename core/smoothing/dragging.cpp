// CurveSmoother: what a drawing would give while a part of it is being dragged.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr double kMargin = 24;  // segments of the drawing, on either side, at first
constexpr double kReach = 6;    // slacks, plus as many edges: what lies farther does not matter
constexpr std::size_t kSettling = 8;  // points of the last result, on either side, that may move
constexpr double kSameWay = 0.5;      // edges that two curves may lie apart where they are joined

using Points = std::vector<SurfacePoint>;

/// Elements that two curves can meet on: edges, and vertices after them.
std::size_t element_of(const SurfacePoint& point) {
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return 2 * e->edge.index();
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return 2 * v->vertex.index() + 1;
  return SIZE_MAX;
}

/// Where two curves go on as one.
struct Joint {
  std::size_t in_stretch = 0, in_last = 0;
};

/// The points of a stretch, [first, last), where the last result passes the same edge, or vertex,
/// the nearest to it; none where it passes none of them.
std::optional<Joint> joint(const Surface& surface, const Points& stretch, std::size_t first,
                           std::size_t last, const Points& result) {
  std::vector<std::pair<std::size_t, std::size_t>> elements;  // and the point of the stretch
  for (std::size_t i = first; i < last; ++i) elements.emplace_back(element_of(stretch[i]), i);
  std::sort(elements.begin(), elements.end());
  std::optional<Joint> best;
  double least = HUGE_VAL;
  for (std::size_t j = 0; j < result.size(); ++j) {
    const std::size_t element = element_of(result[j]);
    auto at =
        std::lower_bound(elements.begin(), elements.end(), std::pair(element, std::size_t{0}));
    for (; element != SIZE_MAX && at != elements.end() && at->first == element; ++at) {
      double gap = 0, edge = 1;
      if (const auto* e = std::get_if<OnEdge>(&result[j].where())) {
        edge = surface.length(e->edge);
        gap = std::abs(e->t - std::get<OnEdge>(stretch[at->second].where()).t) * edge;
      }
      if (gap > kSameWay * edge || gap >= least) continue;
      least = gap;
      best = Joint{at->second, j};
    }
  }
  return best;
}

/// How many points, from `from` on in steps of `step`, lie within `length` along the curve.
std::size_t points_within(const SurfaceMesh& mesh, const Points& points, std::size_t from, int step,
                          std::size_t most, double length) {
  std::size_t count = 0;
  double sum = 0;
  for (std::size_t i = from; count < most; ++count) {
    const std::size_t next = step > 0 ? i + 1 : i - 1;
    sum += (mesh.position(points[next]) - mesh.position(points[i])).norm();
    if (sum > length) break;
    i = next;
  }
  return count;
}

bool same_result(const SmoothingOptions& a, const SmoothingOptions& b) {
  return a.tau == b.tau && a.slack == b.slack && a.slack_at == b.slack_at &&
         a.phase_turns == b.phase_turns && a.polish == b.polish &&
         a.relax_rounds == b.relax_rounds && a.max_iterations == b.max_iterations &&
         a.min_relative_length == b.min_relative_length && a.length_floor == b.length_floor;
}

/// The values at points that are kept; linear at those between them.
std::vector<double> carried_over(const std::vector<double>& drawn, const SurfaceCurve& before,
                                 const DrawingChange& change) {
  std::vector<double> own = drawn;
  if (change.before.closed) {  // it may begin elsewhere
    const auto start =
        std::find(before.points.begin(), before.points.end(), change.before.points.front());
    std::rotate(own.begin(), own.begin() + (start - before.points.begin()), own.end());
  }
  std::vector<double> result(own.begin(),
                             own.begin() + static_cast<std::ptrdiff_t>(change.kept_before));
  const std::vector<double> tail(own.end() - static_cast<std::ptrdiff_t>(change.kept_after),
                                 own.end());
  const double from = result.empty() ? (tail.empty() ? own.front() : tail.front()) : result.back();
  const double to = tail.empty() ? from : tail.front();
  const std::size_t n = change.new_points();
  for (std::size_t k = 1; k <= n; ++k) {
    result.push_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(n + 1));
  }
  result.insert(result.end(), tail.begin(), tail.end());
  return result;
}

}  // namespace

/// The last result if it is what these options ask for.
SmoothingResult CurveSmoother::result_for(const SmoothingOptions& options) {
  SmoothingOptions plain = with_ordered_slack(options);
  if (!last_ || !same_result(last_->options, plain)) {
    plain.deviation = DeviationMeasure::kNone;
    smooth_now(plain);
  }
  return drawing_.as_drawn(last_->result);
}

/// As for the drawing that is set, whose slack and L stay.
std::vector<Corridor::Valley> CurveSmoother::dragged_valleys(
    const DrawingChange& change, std::size_t curve, const SmoothingOptions& options) const {
  std::vector<Corridor::Valley> valleys =
      drawing_.in_drawn_order(valleys_for(with_ordered_slack(options)));
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    valleys[c].slack_at = c == curve
                              ? carried_over(options.slack_at[c], drawing_.drawn()[c], change)
                              : options.slack_at[c];
  }
  return valleys;
}

void CurveSmoother::set_stretch(const DragStretch& stretch, const CurveOptions& options,
                                const Progress& progress) {
  forget();
  try {
    CurveOptions own = options;
    std::erase_if(own.pins, [&](const SurfacePoint& pin) {
      const Points& points = stretch.curve.points;
      return std::find(points.begin(), points.end(), pin) == points.end();
    });
    take(std::span(&stretch.curve, 1), own, progress);
    embed_drawn(progress);
    if (!exact_distance_) exact_distance_.emplace(mesh_->surface());
    Asker asker(progress, "solve");
    const AskedDuring asked(*exact_distance_, asker);
    exact_distance_->set(stretch.near);
    valleys_ = stretch.valleys;
  } catch (...) {
    forget();
    throw;
  }
}

/// From the drawing to where the polish of the result starts.
SurfaceCurve CurveSmoother::rough_stretch(const SmoothingOptions& options) {
  StageTimes times;
  anchors_.clear();
  const Anchor& anchor = anchor_at(*anchor_of(options), options, valleys_, times);
  return drawing_.as_drawn(SmoothingResult{anchor.rough, {}, {}}).curves.front();
}

/// Which points of the changed drawing are smoothed anew, [first, last].
struct CurveSmoother::DragRange {
  std::size_t first = 0, last = 0;
  double before = 0, after = 0;  // how far that is beyond the change, mesh units
};

/// With so much on either side of the change; none where all of the curve would be.
std::optional<CurveSmoother::DragRange> CurveSmoother::range_around(const DrawingChange& change,
                                                                    double margin) const {
  const SurfaceMesh& mesh = mesh_->mesh();
  const Points& points = change.after.points;
  const std::size_t n = points.size(), front = change.kept_before, back = change.kept_after;
  DragRange range{0, n - 1};
  if (front > 0)
    range.first = front - 1 - points_within(mesh, points, front - 1, -1, front - 1, margin);
  if (back > 0) range.last = n - back + points_within(mesh, points, n - back, +1, back - 1, margin);
  const bool at_start = range.first == 0, at_end = range.last == n - 1;
  if (change.after.closed ? at_start || at_end : at_start && at_end) return std::nullopt;
  return range;
}

/// Smooths these points of the drawing and puts them between what stays of the last result; none
/// where they do not meet it.
std::optional<SurfaceCurve> CurveSmoother::joined(const DragRange& range,
                                                  const DrawingChange& change, double margin,
                                                  const SurfaceCurve& last,
                                                  const SmoothingOptions& options) {
  const SurfaceMesh& mesh = mesh_->mesh();
  const Points stretch = dragger_->rough_stretch(options).points;
  const std::size_t m = stretch.size(), open_end = m - 1;
  const auto within = [&](std::size_t from, int step, double length) {
    return points_within(mesh, stretch, from, step, m - 1, length);
  };
  std::optional<Joint> head = Joint{0, 0}, tail = Joint{open_end, last.points.size() - 1};
  if (change.after.closed || range.first > 0) {
    head = joint(mesh.surface(), stretch, within(0, +1, margin / 5), within(0, +1, 0.6 * margin),
                 last.points);
  }
  if (change.after.closed || range.last + 1 < change.after.points.size()) {
    tail = joint(mesh.surface(), stretch, m - within(m - 1, -1, 0.6 * margin),
                 m - within(m - 1, -1, margin / 5), last.points);
  }
  if (!head || !tail || head->in_stretch >= tail->in_stretch) return std::nullopt;

  Points kept = last.points;
  const std::size_t n = kept.size();
  if (last.closed) {  // let it begin just before the joint
    const std::size_t start = (head->in_last + n - kSettling) % n;
    std::rotate(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(start), kept.end());
    head->in_last = kSettling;
    tail->in_last = (tail->in_last + n - start) % n;
  }
  if (tail->in_last <= head->in_last) return std::nullopt;
  const std::size_t from = head->in_last - std::min(kSettling, head->in_last);
  const std::size_t to = tail->in_last + std::min(kSettling, n - 1 - tail->in_last);
  if (last.closed && to + 2 >= n) return std::nullopt;
  const auto at = [](const Points& points, std::size_t i) {
    return points.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::vector<SurfaceCurve> chain(1);
  Points& points = chain.front().points;
  points.assign(at(kept, from), at(kept, head->in_last));
  points.insert(points.end(), at(stretch, head->in_stretch), at(stretch, tail->in_stretch + 1));
  points.insert(points.end(), at(kept, tail->in_last + 1), at(kept, to + 1));
  const Corridor corridor(*dragger_->exact_distance_, options.tau, dragger_->valleys_);
  dragger_->polish_in(corridor, chain, options.progress);
  points.insert(points.begin(), kept.cbegin(), at(std::as_const(kept), from));
  points.insert(points.end(), at(std::as_const(kept), to + 1), kept.cend());
  chain.front().closed = last.closed;
  return std::move(chain.front());
}

SurfaceCurve CurveSmoother::dragged(const DrawingChange& change, std::size_t curve,
                                    const SurfaceCurve& last, const SmoothingOptions& options) {
  const SurfaceMesh& mesh = mesh_->mesh();
  std::vector<SurfaceCurve> curves = drawing_.drawn();
  curves[curve] = change.after;
  const std::vector<Corridor::Valley> valleys = dragged_valleys(change, curve, options);
  const double segment = drawing_.measures()[drawing_.place_of(curve)].length /
                         static_cast<double>(change.before.points.size());
  double slack = valleys[curve].slack;
  for (const double s : valleys[curve].slack_at) slack = std::max(slack, s);
  const double reach = kReach * (slack + drawing_.edges_near()[drawing_.place_of(curve)]);
  if (!dragger_) dragger_ = std::make_unique<CurveSmoother>(mesh_);
  dragger_->loops_ = Loops::kErase;
  if (anchor_of(options)) {
    for (double margin = kMargin * segment;; margin *= 2) {
      const std::optional<DragRange> range = range_around(change, margin);
      if (!range) break;
      dragger_->set_stretch(
          stretch_of(mesh, curves, valleys, curve, range->first, range->last + 1, reach),
          curve_options_, options.progress);
      if (auto result = joined(*range, change, margin, last, options)) return *std::move(result);
    }
  }
  dragger_->set_stretch(
      stretch_of(mesh, curves, valleys, curve, 0, change.after.points.size(), reach),
      curve_options_, options.progress);
  SmoothingOptions plain = options;
  plain.deviation = DeviationMeasure::kNone;
  SmoothingResult result =
      dragger_->drawing_.as_drawn(dragger_->smooth_in_valleys(plain, dragger_->valleys_));
  return std::move(result.curves.front());
}

/// A stretch is not enough where strips meet or faces are divided: all is smoothed anew.
SmoothingResult CurveSmoother::drag_whole(std::size_t curve, const SurfaceCurve& moved,
                                          const SmoothingOptions& options) {
  std::vector<SurfaceCurve> curves = drawing_.drawn();
  curves[curve] = moved;
  CurveOptions own = curve_options_;
  std::erase_if(own.pins, [&](const SurfacePoint& pin) {
    return std::none_of(curves.begin(), curves.end(), [&](const SurfaceCurve& c) {
      return std::find(c.points.begin(), c.points.end(), pin) != c.points.end();
    });
  });
  SmoothingOptions plain = options;
  plain.slack_at.clear();  // it belongs to the drawing that is set
  if (!dragger_) dragger_ = std::make_unique<CurveSmoother>(mesh_);
  dragger_->loops_ = Loops::kKeep;
  if (!dragger_->set_curves(curves, own, options.progress)) throw Cancelled();
  SmoothingResult result = dragger_->drawing_.as_drawn(dragger_->smooth_now(plain));
  result.reports[curve].engine = "preview";
  result.total = total_of(result.reports);
  return result;
}

SmoothingResult CurveSmoother::drag(std::size_t curve, const SurfaceCurve& moved,
                                    const SmoothingOptions& options) {
  const auto require = [](bool good, const char* message) {
    if (!good) throw Error(ErrorCode::kBadUsage, message);
  };
  options.validate();
  require(is_set(), "No curve is set.");
  require(curve_options_.method == Method::kCorridor, "drag() needs the corridor.");
  require(curve < drawing_.drawn().size(), "drag() is asked for a curve that is not set.");
  const SurfaceCurve own = moved;  // NOLINT: may be our own drawing, which changes
  check_drawn(mesh_->surface(), own);
  try {
    const Asker asked(options.progress, "straighten");
    return drag_now(curve, own, options);
  } catch (const Cancelled&) {
    SmoothingResult result = cancelled_result(options);
    result.curves[curve] = own;
    return result;
  }
}

SmoothingResult CurveSmoother::drag_now(std::size_t curve, const SurfaceCurve& own,
                                        const SmoothingOptions& options) {
  if (unrolled_ || !refined_.empty()) return drag_whole(curve, own, options);
  SmoothingResult result = result_for(options);
  const Stopwatch watch;
  const DrawingChange change = change_between(drawing_.drawn()[curve], own);
  if (!change.is_none())
    result.curves[curve] = dragged(change, curve, result.curves[curve], options);

  SmoothingReport& report = result.reports[curve];
  SmoothingReport fresh = report_on_curve(mesh_->mesh(), own, measure_curve(mesh_->surface(), own),
                                          result.curves[curve]);
  fresh.potential = report.potential;
  fresh.engine = "preview";
  fresh.tau = report.tau;
  fresh.slack = report.slack;
  fresh.edge_length_near = report.edge_length_near;
  fresh.termination = report.termination;
  report_deviation(fresh, measure_for(options), *deviation_meter_, mesh_->mesh(), own,
                   result.curves[curve], nullptr, options.progress);
  warn_if_far(fresh, kFarInEdges * fresh.edge_length_near,
              options.deviation == DeviationMeasure::kAutomatic);
  fresh.time_ms.polish = fresh.time_ms.total = watch.ms();
  fresh.peak_memory_mib = report.peak_memory_mib;
  report = std::move(fresh);
  result.total = total_of(result.reports);
  return result;
}

}  // namespace talweg

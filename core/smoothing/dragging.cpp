#include "talweg/core/smoothing/dragging.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "talweg/core/smoothing/corridor_valleys.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr double kMargin = 24;  // in segments of the drawing, on either side, doubled on failure
constexpr double kReach = 6;    // times slack + edge: curves farther away have no effect
constexpr std::size_t kSettling =
    16;  // points of the last result, on either side, that are faired again
constexpr double kSameWay = 0.5;  // times the edge: largest gap of two curves at a joint

using Points = std::vector<SurfacePoint>;

/// The point indices where a stretch and the last result are joined.
struct Joint {
  std::size_t in_stretch = 0, in_last = 0;
};

/// The joint among the stretch's points [first, last): the nearest pair of points on the same edge
/// or vertex; empty if the last result passes none of these elements.
std::optional<Joint> joint(const Surface& surface, const Points& stretch, std::size_t first,
                           std::size_t last, const Points& result) {
  std::vector<std::pair<SurfaceElement, std::size_t>> elements;  // with the stretch's point
  for (std::size_t i = first; i < last; ++i) elements.emplace_back(element_of(stretch[i]), i);
  std::sort(elements.begin(), elements.end());
  std::optional<Joint> best;
  double least = HUGE_VAL;
  for (std::size_t j = 0; j < result.size(); ++j) {
    const SurfaceElement element = element_of(result[j]);
    if (element.kind == SurfaceElement::Kind::kFace) continue;  // joints lie on edges and vertices
    auto at =
        std::lower_bound(elements.begin(), elements.end(), std::pair(element, std::size_t{0}));
    for (; at != elements.end() && at->first == element; ++at) {
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

/// The number of points, at most `most`, that follow `from` in direction `step` within `length`
/// (mesh units) along the curve.
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

/// The values at the points of the changed curve: unchanged at kept points, linear between.
std::vector<double> carried_over(const std::vector<double>& drawn, const SurfaceCurve& before,
                                 const DrawingChange& change) {
  std::vector<double> own = drawn;
  if (change.before.closed) {  // the change may have rotated the loop
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

/// The valleys of the changed drawing, in drawn order. Slack and L are those of the drawing that is
/// set; an estimated slack that varies along a curve is replaced by its constant value while
/// dragging.
std::vector<Corridor::Valley> dragged_valleys(const SurfaceMesh& mesh,
                                              const Dragging::Setting& setting, std::size_t curve,
                                              const DrawingChange& change) {
  const OrderedDrawing& drawing = setting.drawing;
  const SmoothingOptions& options = setting.options;
  std::vector<Corridor::Valley> valleys = drawing.in_drawn_order(
      with_options(setting.valleys, mesh, drawing, drawing.ordered(options)));
  if (options.slack_at.empty()) {
    for (Corridor::Valley& valley : valleys) valley.slack_at.clear();
  }
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    valleys[c].slack_at = c == curve ? carried_over(options.slack_at[c], drawing.drawn()[c], change)
                                     : options.slack_at[c];
  }
  return valleys;
}

}  // namespace

void Dragging::set(const DragStretch& stretch, const CurveOptions& options,
                   const Progress& progress) {
  CurveOptions own = options;
  const PointLookup here(stretch.curve.points);
  const auto is_elsewhere = [&](const SurfacePoint& pin) { return !here.contains(pin); };
  std::erase_if(own.pins, is_elsewhere);
  std::erase_if(own.corners, is_elsewhere);
  std::erase_if(own.painted, is_elsewhere);
  stretch_ = {};
  stretch_.drawing =
      checked_drawing(memory_.mesh(), std::span(&stretch.curve, 1), {}, own, progress);
  stretch_.embedded.emplace(memory_, stretch_.drawing, own,
                            EmbeddedDrawing::Ground{Loops::kErase, nullptr}, progress);
  stretch_.method.emplace(memory_, *stretch_.embedded);
  std::vector<SurfaceCurve> near = stretch.near;
  std::vector<Corridor::Valley> valleys = stretch.valleys;
  // A stretch that is the whole curve must be in the order of the checked drawing.
  if (near.front().points == stretch.curve.points) {
    near.front() = stretch_.drawing.curves().front();
    std::vector<double>& slack_at = valleys.front().slack_at;
    if (!slack_at.empty()) {
      SmoothingOptions ordered;
      ordered.slack_at = {slack_at};
      slack_at = stretch_.drawing.ordered(std::move(ordered)).slack_at.front();
    }
  }
  stretch_.method->set(near, std::move(valleys), progress);
}

/// The points of the changed drawing that are smoothed again, [first, last].
struct Dragging::Range {
  std::size_t first = 0, last = 0;
  double before = 0, after = 0;  // length of the range beyond the change, mesh units
};

/// The range with `margin` (mesh units) on either side of the change; empty if it would be the
/// whole curve.
std::optional<Dragging::Range> Dragging::range_around(const DrawingChange& change,
                                                      double margin) const {
  const SurfaceMesh& mesh = memory_.mesh();
  const Points& points = change.after.points;
  const std::size_t n = points.size(), front = change.kept_before, back = change.kept_after;
  Range range{0, n - 1};
  if (front > 0)
    range.first = front - 1 - points_within(mesh, points, front - 1, -1, front - 1, margin);
  if (back > 0) range.last = n - back + points_within(mesh, points, n - back, +1, back - 1, margin);
  const bool at_start = range.first == 0, at_end = range.last == n - 1;
  if (change.after.closed ? at_start || at_end : at_start && at_end) return std::nullopt;
  return range;
}

/// Smooths the range of the drawing and joins it to the unchanged parts of the last result; empty
/// if there is no joint.
std::optional<SurfaceCurve> Dragging::joined(const Range& range, const DrawingChange& change,
                                             double margin, const SurfaceCurve& last,
                                             const SmoothingOptions& options,
                                             const Progress& progress) {
  const SurfaceMesh& mesh = memory_.mesh();
  const Points stretch =
      stretch_.drawing.in_drawn_direction(0, stretch_.method->taut(options, progress)[0]).points;
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
  if (last.closed) {  // rotated to begin just before the joint
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
  SurfaceCurve between;
  between.points.assign(at(kept, from), at(kept, head->in_last));
  between.points.insert(between.points.end(), at(stretch, head->in_stretch),
                        at(stretch, tail->in_stretch + 1));
  between.points.insert(between.points.end(), at(kept, tail->in_last + 1), at(kept, to + 1));
  // The second and the last but one point are fixed, which keeps the directions at the joints.
  std::vector<SurfacePoint> fixed = stretch_.embedded->fixed();
  if (from < head->in_last) fixed.push_back(between.points[1]);
  if (tail->in_last < to) fixed.push_back(between.points[between.points.size() - 2]);
  std::optional<SurfaceCurve> faired = stretch_.method->fair(options.tau, between, fixed, progress);
  if (!faired) return std::nullopt;
  faired->points.insert(faired->points.begin(), kept.cbegin(), at(std::as_const(kept), from));
  faired->points.insert(faired->points.end(), at(std::as_const(kept), to + 1), kept.cend());
  faired->closed = last.closed;
  return faired;
}

SurfaceCurve Dragging::dragged(const Setting& setting, std::size_t curve,
                               const DrawingChange& change, const SurfaceCurve& last,
                               const Progress& progress) {
  const OrderedDrawing& drawing = setting.drawing;
  std::vector<SurfaceCurve> curves = drawing.drawn();
  curves[curve] = change.after;
  const std::vector<Corridor::Valley> valleys =
      dragged_valleys(memory_.mesh(), setting, curve, change);
  const std::size_t place = drawing.place_of(curve);
  const double segment =
      drawing.measures()[place].length / static_cast<double>(change.before.points.size());
  double slack = valleys[curve].slack;
  for (const double s : valleys[curve].slack_at) slack = std::max(slack, s);
  const double reach = kReach * (slack + drawing.edges_near()[place]);
  const auto set_stretch = [&](std::size_t first, std::size_t last_point) {
    set(stretch_of(memory_.mesh(), curves, valleys, curve, first, last_point, reach),
        setting.curve_options, progress);
  };
  const SmoothingOptions own = setting.options.of(curve);
  if (FairLadder::rung_of(own, 0)) {
    for (double margin = kMargin * segment;; margin *= 2) {
      const std::optional<Range> range = range_around(change, margin);
      if (!range) break;
      set_stretch(range->first, range->last + 1);
      auto result = joined(*range, change, margin, last, own, progress);
      if (result) return *std::move(result);
    }
  }
  set_stretch(0, change.after.points.size());
  DomainResult whole = stretch_.method->smooth_in_own_valleys(own, progress);
  return stretch_.drawing.in_drawn_direction(0, std::move(whole.curves.front().curve));
}

}  // namespace talweg

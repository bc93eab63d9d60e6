#include "talweg/core/labels/label_network.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "talweg/core/labels/local_tightening.hpp"
#include "talweg/core/labels/network_nodes.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr int kRungs = 4;  // levels of smoothing; a border on rung kRungs stays as drawn
constexpr double kSteeper = 4, kNarrower = 0.5;
// The number of times that a border beyond D gets less slack, and the time after which its farthest
// points are pinned, too.
constexpr int kTightenings = 10, kPinnedFrom = 4;
constexpr int kSteps = 6;    // at most, of the nodes towards balance
constexpr int kRetries = 3;  // after holding the nodes of borders that failed a check

class Network {
 public:
  Network(std::shared_ptr<const OpenedMesh> mesh, std::span<const std::int64_t> labels,
          const LabelNetworkOptions& options, Progress progress)
      : mesh_(std::move(mesh)),
        options_(options),
        progress_(options.budget.any() ? progress.with(options.budget) : std::move(progress)),
        drawn_(label_borders(mesh_->surface(), labels)),
        parts_(parts_of_regions(mesh_->mesh(), labels, drawn_)),
        rung_(drawn_.size(), 0),
        tightenings_(drawn_.size(), 0),
        pins_(drawn_.size()),
        slack_(drawn_.size()),
        result_(drawn_.size()),
        smoother_(mesh_) {}

  LabelNetwork run() {
    std::vector<std::size_t> todo(drawn_.size());
    for (std::size_t c = 0; c < todo.size(); ++c) todo[c] = c;
    while (!todo.empty()) {
      if (!smooth(todo)) return cancelled();
      note_held(collapsed(todo));
      todo = tighten(too_far(todo));  // before cutting the mesh, which takes longer
      if (!todo.empty()) continue;
      cut();
      note_held(regions_.wrong);
      todo = climb_for(regions_.wrong);
    }
    const bool may_move = options_.free_junctions || options_.sliding_ends;
    if (may_move && !ends_early(progress_) && !balance()) return cancelled();
    return finished();
  }

 private:
  /// Borders that passed all checks, with the mesh cut along them.
  struct State {
    std::vector<SmoothedBorder> result;
    CutMesh cut;
    CutRegions regions;
  };

  enum class Walk { kSound, kUnsound, kCancelled };

  static LabelNetwork cancelled() {
    LabelNetwork result;
    result.cancelled = true;
    return result;
  }

  /// Smooths the given borders, one set per rung. False when cancelled.
  bool smooth(const std::vector<std::size_t>& todo) {
    std::map<int, std::vector<std::size_t>> by_rung;
    for (const std::size_t c : todo) by_rung[rung_[c]].push_back(c);
    for (const auto& [rung, members] : by_rung) {
      if (rung == kRungs) {
        for (const std::size_t c : members) keep_drawn(c);
      } else if (!smooth_set(members, rung)) {
        return false;
      }
    }
    return true;
  }

  /// The drawing of a border, led to the current places of its nodes.
  NetworkNodes::Redrawing drawing(std::size_t c) {
    if (nodes_ && nodes_->is_moved(c)) return nodes_->redrawn(c);
    NetworkNodes::Redrawing same{drawn_[c], {}};
    same.from.resize(drawn_[c].curve.points.size());
    std::iota(same.from.begin(), same.from.end(), 0);
    return same;
  }

  bool smooth_set(const std::vector<std::size_t>& members, int rung) {
    std::vector<NetworkNodes::Redrawing> drawings;
    std::vector<SurfaceCurve> curves;
    CurveOptions curve_options;
    curve_options.join_ends = false;  // junctions with other borders keep their ends apart
    const auto pin = [&](const SurfacePoint& p) { curve_options.pins.push_back(p); };
    for (const std::size_t c : members) {
      const LabelBorder& border = drawings.emplace_back(drawing(c)).border;
      curves.push_back(border.curve);
      for (const SurfacePoint& p : border.fixed) pin(p);
      for (const SurfacePoint& p : pins_[c]) {
        const auto& points = border.curve.points;
        if (std::find(points.begin(), points.end(), p) != points.end()) pin(p);
      }
    }
    if (!smoother_.set_curves(curves, curve_options, progress_)) return false;
    give_slack(members);
    SmoothingOptions options;
    if (options_.max_deviation) options.deviation = DeviationMeasure::kAlongSurface;
    if (nodes_)
      options.deviation =
          DeviationMeasure::kNone;  // measure_moved() compares with the original drawing
    options.tau = options_.tau * std::pow(kSteeper, rung);
    if (rung > 0 && options.tau == 0) options.tau = std::pow(kSteeper, rung - 1);
    for (std::size_t i = 0; i < members.size(); ++i) {
      std::vector<double>& slack = options.slack_at.emplace_back();
      for (const std::size_t from : drawings[i].from) slack.push_back(slack_[members[i]][from]);
    }
    SmoothingResult smoothed = smoother_.smooth(options, progress_);
    if (smoothed.total.termination == Outcome::kCancelled) return false;
    add_times(smoothed.total.time_ms);
    for (std::size_t i = 0; i < members.size(); ++i) {
      LabelBorder& border = drawings[i].border;
      border.curve = std::move(smoothed.curves[i]);
      result_[members[i]] = {std::move(border), std::move(smoothed.reports[i]), false};
    }
    return true;
  }

  void add_times(const StageTimes& of_set) {
    spent_.open = of_set.open;  // once
    for (double StageTimes::*stage :
         {&StageTimes::solve, &StageTimes::straighten, &StageTimes::trace, &StageTimes::relax,
          &StageTimes::fair, &StageTimes::measure, &StageTimes::total}) {
      spent_.*stage += of_set.*stage;
    }
    spent_.total -= of_set.open;
  }

  /// The time outside of smoothing counts as measuring, because it checks the results.
  [[nodiscard]] StageTimes times() const {
    StageTimes all = spent_;
    const double elapsed = std::max(watch_.ms(), spent_.total);
    all.measure += elapsed - spent_.total;
    all.total = all.open + elapsed;
    return all;
  }

  [[nodiscard]] double mean_segment(std::size_t border) const {
    const SurfaceCurve& drawn = drawn_[border].curve;
    return curve_length(mesh_->surface(), drawn) / static_cast<double>(drawn.points.size());
  }

  /// Gives a slack to borders without one: at least a third of the border's mean segment, because
  /// short borders are as jagged as long ones.
  void give_slack(const std::vector<std::size_t>& members) {
    const std::vector<double> own = smoother_.slack();
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (!slack_[members[i]].empty()) continue;
      double slack = options_.slack.value_or(std::max(own[i], mean_segment(members[i]) / 3));
      if (options_.max_deviation) slack = std::min(slack, 0.75 * *options_.max_deviation);
      slack_[members[i]].assign(drawn_[members[i]].curve.points.size(), slack);
    }
  }

  void keep_drawn(std::size_t c) {
    SmoothingReport report = std::move(result_[c].report);
    const LabelBorder& drawn = drawn_[c];
    const SmoothingReport same =
        report_on_curve(mesh_->mesh(), drawn.curve, report.edge_length_near, drawn.curve);
    report.points_after = same.points_after;
    report.after = same.after;
    report.lifted_length_after = report.lifted_length_before;
    report.deviation_to_drawn_max = report.deviation_to_drawn_mean = 0;
    report.deviation_from_drawn_max = report.deviation_from_drawn_mean = 0;
    report.deviation_exact = true;
    report.deviation_at_least = 0;
    report.slack = 0;
    report.termination = Outcome::kConverged;
    report.missed_points = 0;
    report.missed_max = 0;
    report.warnings = {"No smoothed border passed the checks, so the border stays as drawn."};
    report.decisive.clear();
    result_[c] = {drawn, std::move(report), true};
  }

  [[nodiscard]] bool has_collapsed(std::size_t border) const {
    return result_[border].report.termination == Outcome::kCollapsed;
  }
  [[nodiscard]] std::vector<std::size_t> collapsed(const std::vector<std::size_t>& among) const {
    std::vector<std::size_t> gone;
    for (const std::size_t c : among) {
      if (has_collapsed(c)) gone.push_back(c);
    }
    return gone;
  }

  /// The borders that have collapsed or lie beyond D.
  [[nodiscard]] std::vector<std::size_t> too_far(const std::vector<std::size_t>& among) const {
    std::vector<std::size_t> far;
    for (const std::size_t c : among) {
      const SmoothingReport& report = result_[c].report;
      const double apart = std::max(report.deviation_to_drawn_max, report.deviation_from_drawn_max);
      if (has_collapsed(c) || (options_.max_deviation && !(apart <= *options_.max_deviation))) {
        far.push_back(c);
      }
    }
    return far;
  }

  /// Gives borders beyond D less slack near the stretches that are too far; collapsed borders and
  /// borders that have been tightened kTightenings times go to the next rung. Returns the borders
  /// to smooth.
  std::vector<std::size_t> tighten(const std::vector<std::size_t>& borders) {
    std::vector<std::size_t> moved, rest;
    for (const std::size_t c : borders) {
      if (has_collapsed(c) || tightenings_[c] == kTightenings || rung_[c] == kRungs ||
          ends_early(progress_)) {
        rest.push_back(c);
        continue;
      }
      if (!tightening_) tightening_.emplace(mesh_->surface());
      std::vector<double> slack = slack_[c];
      const std::vector<SurfacePoint> farthest = tightening_->tighten(
          drawn_[c].curve, result_[c].border.curve, *options_.max_deviation, slack, progress_);
      const double least = mean_segment(c) / 6;  // a smaller slack leaves no room for fairing
      for (std::size_t i = 0; i < slack.size(); ++i) {
        slack_[c][i] = std::max(slack[i], std::min(slack_[c][i], least));
      }
      if (++tightenings_[c] > kPinnedFrom) {
        pins_[c].insert(pins_[c].end(), farthest.begin(), farthest.end());
      }
      moved.push_back(c);
    }
    rest = climb(rest);
    moved.insert(moved.end(), rest.begin(), rest.end());
    std::sort(moved.begin(), moved.end());
    return moved;
  }

  /// Moves borders to the next rung, or to rung kRungs if the budget is used up. Returns the
  /// borders that moved.
  std::vector<std::size_t> climb(const std::vector<std::size_t>& borders) {
    std::vector<std::size_t> moved;
    for (const std::size_t c : borders) {
      if (rung_[c] == kRungs) continue;
      rung_[c] = ends_early(progress_) ? kRungs : rung_[c] + 1;
      for (double& slack : slack_[c]) slack *= kNarrower;
      moved.push_back(c);
    }
    return moved;
  }

  /// Moves wrong borders to the next rung. If all of them are as drawn already, other borders
  /// beside the same parts must be wrong, and these borders move.
  std::vector<std::size_t> climb_for(const std::vector<std::size_t>& wrong) {
    std::vector<std::size_t> moved = climb(wrong);
    if (!moved.empty() || wrong.empty()) return moved;
    std::vector<bool> has_part(parts_.parts.size(), false);
    for (const std::size_t c : wrong) {
      for (const std::uint32_t part : parts_.beside[c]) has_part[part] = true;
    }
    std::vector<std::size_t> around;
    for (std::size_t c = 0; c < drawn_.size(); ++c) {
      const auto [left, right] = parts_.beside[c];
      if (has_part[left] || has_part[right]) around.push_back(c);
    }
    return climb(around);
  }

  [[nodiscard]] std::vector<SurfaceCurve> curves() const {
    std::vector<SurfaceCurve> curves;
    for (const SmoothedBorder& border : result_) curves.push_back(border.border.curve);
    return curves;
  }

  /// Cuts the mesh along the borders and assigns the faces to the regions. Throws Cancelled.
  void cut() {
    std::vector<LabelBorder> borders;
    for (const SmoothedBorder& border : result_) borders.push_back(border.border);
    cut_ = cut_along(mesh_->mesh(), curves(), {}, [&](const char* stage, double fraction) {
      return go_on(progress_, stage, fraction / 2);
    });
    regions_ = regions_of_cut(cut_, parts_, borders);
  }

  /// Moves the nodes towards balance of their borders and smooths these borders again. The nodes of
  /// a border that then fails a check return to their drawn places. False when cancelled.
  bool balance() {
    const State settled{result_, cut_, regions_};
    std::vector<double> tolerance;
    for (std::size_t c = 0; c < drawn_.size(); ++c) {
      const double slack = std::min(slack_[c].front(), slack_[c].back());
      tolerance.push_back(result_[c].as_drawn      ? 0
                          : options_.max_deviation ? 0.75 * *options_.max_deviation
                                                   : slack);
    }
    const NetworkNodes::Rules rules{options_.free_junctions, options_.sliding_ends};
    nodes_.emplace(mesh_->mesh(), drawn_, tolerance, rules);
    imbalance_ = nodes_->imbalance(curves());
    Walk outcome = Walk::kUnsound;
    try {
      outcome = walk(settled);
    } catch (const Error& error) {  // the nodes of a border are too near each other
      if (error.code() != ErrorCode::kBadCurve) throw;
    }
    if (outcome == Walk::kUnsound) {
      result_ = settled.result;
      cut_ = settled.cut;
      regions_ = settled.regions;
      nodes_.reset();
    }
    return outcome != Walk::kCancelled;
  }

  Walk walk(const State& settled) {
    for (int k = 0; k < kSteps; ++k) {
      if (k > 0 && ends_early(progress_)) break;
      const std::vector<std::size_t> changed = nodes_->step(curves());
      if (changed.empty()) break;
      if (!smooth(changed)) return Walk::kCancelled;
    }
    for (int tries = 0; tries < kRetries; ++tries) {
      std::vector<std::size_t> wrong = measure_moved();
      if (wrong.empty()) {
        cut();
        wrong = regions_.wrong;
      }
      if (wrong.empty()) return Walk::kSound;
      const std::vector<std::size_t> back = nodes_->hold(wrong);
      if (back.empty()) break;
      if (!smooth_from(settled, back)) return Walk::kCancelled;
    }
    return Walk::kUnsound;
  }

  /// Restores the settled result of borders without moved nodes, and smooths the others. False when
  /// cancelled.
  bool smooth_from(const State& settled, const std::vector<std::size_t>& borders) {
    std::vector<std::size_t> todo;
    for (const std::size_t c : borders) {
      if (nodes_->is_moved(c)) {
        todo.push_back(c);
      } else {
        result_[c] = settled.result[c];
      }
    }
    return smooth(todo);
  }

  /// Updates the reports of borders with moved nodes. Returns the borders that have collapsed or
  /// lie beyond D.
  std::vector<std::size_t> measure_moved() {
    if (!meter_) meter_.emplace(mesh_->mesh());
    std::vector<std::size_t> moved;
    for (std::size_t c = 0; c < drawn_.size(); ++c) {
      if (!nodes_->is_moved(c)) continue;
      moved.push_back(c);
      const SurfaceCurve& drawn = drawn_[c].curve;
      const SurfaceCurve& curve = result_[c].border.curve;
      SmoothingReport& report = result_[c].report;
      const SmoothingReport fresh =
          report_on_curve(mesh_->mesh(), drawn, report.edge_length_near, curve);
      report.points_before = fresh.points_before;
      report.before = fresh.before;
      report_deviation(report,
                       measure_deviation(DeviationMeasure::kAlongSurface, report.edge_length_near,
                                         *meter_, mesh_->mesh(), drawn, curve, nullptr, progress_));
      warn_if_far(report, kFarInEdges * report.edge_length_near);
    }
    return too_far(moved);
  }

  /// Marks the smaller of the two parts beside each wrong border as held: it would have been lost.
  void note_held(const std::vector<std::size_t>& wrong) {
    held_.resize(parts_.parts.size(), false);
    for (const std::size_t c : wrong) {
      const auto [left, right] = parts_.beside[c];
      held_[parts_.parts[left].area <= parts_.parts[right].area ? left : right] = true;
    }
  }

  [[nodiscard]] std::vector<LabelRegion> region_table() const {
    std::map<std::int64_t, LabelRegion> regions;
    for (std::size_t p = 0; p < parts_.parts.size(); ++p) {
      LabelRegion& region = regions[parts_.parts[p].label];
      region.label = parts_.parts[p].label;
      ++region.parts_before;
      region.area_before += parts_.parts[p].area;
      region.area_after += regions_.area[p];
      region.held = region.held || held_[p];
      region.parts_after += regions_.pieces[p];
    }
    std::vector<LabelRegion> table;
    table.reserve(regions.size());
    for (const auto& [label, region] : regions) table.push_back(region);
    return table;
  }

  LabelNetwork finished() {
    LabelNetwork network;
    if (nodes_) network.moved = nodes_->moved_count();
    network.imbalance_before = imbalance_;
    network.imbalance_after = nodes_ ? nodes_->imbalance(curves()) : imbalance_;
    network.regions = region_table();
    network.junctions = count_junctions(mesh_->surface(), drawn_);
    std::vector<SmoothingReport> reports;
    for (std::size_t c = 0; c < result_.size(); ++c) {
      if (result_[c].as_drawn) ++network.as_drawn;
      if (!result_[c].as_drawn && (rung_[c] > 0 || tightenings_[c] > 0)) ++network.tightened;
      if (options_.max_deviation) result_[c].report.max_deviation = *options_.max_deviation;
      reports.push_back(result_[c].report);
    }
    network.total = total_of(reports);
    network.total.time_ms = times();
    if (has_ended_early(progress_)) {
      network.total.termination = std::max(network.total.termination, Outcome::kLimit);
      network.total.warnings.emplace_back(
          "The budget was used up: some borders bend more than necessary, or stay as drawn.");
    }
    network.borders = std::move(result_);
    for (const std::uint32_t part : regions_.part_of_face) {
      network.cut_labels.push_back(parts_.parts[part].label);
    }
    network.face_labels = majority_labels(cut_, parts_, regions_, mesh_->surface().face_count());
    network.cut = std::move(cut_);
    return network;
  }

  const Stopwatch watch_;
  std::shared_ptr<const OpenedMesh> mesh_;
  LabelNetworkOptions options_;
  Progress progress_;
  std::vector<LabelBorder> drawn_;
  RegionParts parts_;
  // Per border:
  std::vector<int> rung_, tightenings_;
  std::vector<std::vector<SurfacePoint>> pins_;  // farthest points of the drawing
  std::vector<std::vector<double>> slack_;       // per point of the drawing
  std::vector<SmoothedBorder> result_;
  CurveSmoother smoother_;
  std::optional<LocalTightening> tightening_;  // made when the first border lies beyond D
  std::optional<NetworkNodes> nodes_;          // set while nodes may move
  std::optional<DeviationMeter> meter_;        // used with nodes_
  double imbalance_ = 0;                       // with the nodes at their drawn places
  CutMesh cut_;
  CutRegions regions_;
  std::vector<bool> held_;  // per part
  StageTimes spent_;        // times of smoothing; the total excludes opening the mesh
};

}  // namespace

void LabelNetworkOptions::validate() const {
  const auto bad = [](const char* message) { throw Error(ErrorCode::kBadUsage, message); };
  if (!(tau >= 0 && std::isfinite(tau))) bad("tau must be finite and >= 0.");
  if (slack && !(*slack >= 0 && std::isfinite(*slack))) bad("slack must be finite and >= 0.");
  if (max_deviation && !(*max_deviation > 0 && std::isfinite(*max_deviation))) {
    bad("max_deviation must be finite and > 0.");
  }
  budget.validate();
}

LabelNetwork smooth_labels(const std::shared_ptr<const OpenedMesh>& mesh,
                           std::span<const std::int64_t> labels, const LabelNetworkOptions& options,
                           const Progress& progress) {
  options.validate();
  try {
    const ProgressPoller polled(progress, "borders");
    return Network(mesh, labels, options, progress).run();
  } catch (const Cancelled&) {
    LabelNetwork cancelled;
    cancelled.cancelled = true;
    return cancelled;
  }
}

}  // namespace talweg

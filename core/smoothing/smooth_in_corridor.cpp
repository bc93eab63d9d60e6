// Smoothing with the corridor potential: how wide, from where, and the polish.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/smoothing/corridor_scale.hpp"
#include "talweg/core/smoothing/curve_gaps.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/lifted_lengths.hpp"
#include "talweg/core/smoothing/polish.hpp"
#include "talweg/core/smoothing/relaxation.hpp"
#include "talweg/core/smoothing/touched_edges.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr double kOrigin = 4;  // of the chain of anchors below it
// Anchors that only lead on to lower ones.
const PolishOptions kRough{.max_rounds = 3, .newton_steps = 4, .tolerance = 1e-5};
constexpr double kMostAnchor = 64;
// Where the lift lengthens no edge by more than this part of it, it is not felt: the polish does
// not look for gains that are smaller (PolishOptions::tolerance).
constexpr double kUnfelt = 1e-7;

double largest_slack(const Corridor::Valley& valley) {
  const std::vector<double>& field = valley.slack_at;
  return field.empty() ? valley.slack : *std::max_element(field.begin(), field.end());
}

}  // namespace

std::vector<double> CurveSmoother::slack() const {
  std::vector<double> ordered;
  if (!refined_.empty()) {
    ordered = refined_slack();
  } else if (unrolled_) {
    ordered = unrolled_slack();
  } else {
    for (const Corridor::Valley& valley : valleys_) ordered.push_back(valley.slack);
  }
  if (ordered.empty()) return ordered;  // the paper's method
  return drawing_.in_drawn_order(ordered);
}

void CurveSmoother::make_valleys(const Progress& progress) {
  constexpr std::size_t kOfPoint = 16;  // units of work
  Asker asker(progress, "solve");
  valleys_.clear();
  for (const SurfaceCurve& curve : drawing_.curves()) {
    asker.did(kOfPoint * curve.points.size());
    Corridor::Valley& valley = valleys_.emplace_back();
    valley.closed = curve.closed;
    valley.slack = default_slack(mesh_->surface(), curve);
    valley.length = corridor_length(mesh_->mesh(), curve);
  }
  if (valleys_.size() > 1) keep_valleys_apart(progress);
}

/// Where the slacks of two curves met nothing would keep the curves apart.
void CurveSmoother::keep_valleys_apart(const Progress& progress) {
  constexpr double kOfGap = 0.45;
  double most = 0;
  for (const Corridor::Valley& valley : valleys_) most = std::max(most, valley.slack);
  const std::vector<double> gaps =
      gaps_to_others(mesh_->mesh(), drawing_.curves(), most / kOfGap, progress);
  for (std::size_t c = 0; c < gaps.size(); ++c) {
    valleys_[c].slack = std::min(valleys_[c].slack, kOfGap * gaps[c]);
  }
}

/// For a loop that no slack holds: a strip of width w and length l that closed up would save about
/// 2 l and has to climb to (a tau w / 2)^2 / L on both sides.
void CurveSmoother::steepen(Corridor::Valley& valley, const SurfaceCurve& drawn) const {
  const double width = 4 * width_of_loop(mesh_->mesh(), drawn);
  const double length = curve_length(mesh_->surface(), drawn);
  if (!(width > 0)) return;
  valley.slack = width / 8;
  valley.length = std::min(valley.length, width * width / length);
}

/// A loop that is thin, or small against its slack, could collapse within its own corridor. Whether
/// it does is tried at the smallest tau at which it must not.
void CurveSmoother::hold_loops(const Progress& progress) {
  constexpr double kLeastTau = 0.25;
  constexpr int kHalvings = 8;
  std::vector<bool> doubtful(drawing_.drawn().size(), false);
  for (std::size_t c = 0; c < drawing_.drawn().size(); ++c) {
    const Corridor::Valley& valley = valleys_[c];
    doubtful[c] =
        valley.closed && valley.slack > width_of_loop(mesh_->mesh(), drawing_.curves()[c]);
  }
  if (std::count(doubtful.begin(), doubtful.end(), true) == 0) return;
  // Without pins, which may be taken away later.
  const std::vector<SurfacePoint> pins = std::exchange(curve_options_.pins, {});
  const auto embed_again = [&] {
    if (pins.empty()) return;
    embed_drawn(progress);
  };
  embed_again();
  SmoothingOptions options;
  options.tau = kLeastTau;
  options.polish = false;
  options.deviation = DeviationMeasure::kNone;
  options.progress = progress;
  for (int k = 0; k < kHalvings && std::count(doubtful.begin(), doubtful.end(), true) > 0; ++k) {
    const SmoothingResult tried = smooth_in_corridor(options);
    for (std::size_t c = 0; c < drawing_.drawn().size(); ++c) {
      const SmoothingReport& report = tried.reports[c];
      doubtful[c] = doubtful[c] && (report.termination != to_string(Termination::kConverged) ||
                                    report.length_after < report.length_before / 2);
      if (doubtful[c]) valleys_[c].slack /= 2;
    }
  }
  for (std::size_t c = 0; c < drawing_.drawn().size(); ++c) {
    if (doubtful[c]) steepen(valleys_[c], drawing_.curves()[c]);
  }
  curve_options_.pins = pins;
  embed_again();
  last_.reset();
}

std::vector<Corridor::Valley> CurveSmoother::valleys_for(const SmoothingOptions& options) const {
  std::vector<Corridor::Valley> valleys = valleys_;
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    Corridor::Valley& valley = valleys[c];
    if (options.slack) valley.slack = *options.slack;
    if (!options.slack_at.empty()) valley.slack_at = options.slack_at[c];
    // With fewer points to a turn the phase could not follow the loop.
    const std::size_t most = std::max<std::size_t>(drawing_.curves()[c].points.size() / 8, 1);
    valley.turns = std::min(options.phase_turns, static_cast<int>(most));
  }
  return valleys;
}

/// From which anchor the result for this tau is polished: the power of two below it; none where it
/// is straightened for itself.
std::optional<double> CurveSmoother::anchor_of(const SmoothingOptions& options) {
  const double tau = options.tau;
  const bool plain = options.polish && options.max_iterations == 0 &&
                     options.min_relative_length == 0 && options.relax_rounds == 0;
  if (!plain || !(tau >= kLeastAnchor && tau <= kMostAnchor)) return std::nullopt;
  return std::exp2(std::floor(std::log2(tau)));
}

void CurveSmoother::polish_in(const Corridor& corridor, std::vector<SurfaceCurve>& curves,
                              const Progress& progress, const PolishOptions& options) {
  const SurfaceMesh& mesh = mesh_->mesh();
  Asker asker(progress, "polish");
  const AskedDuring asked(*exact_distance_, asker);
  const ExactPotential exact = {
      [&](EdgeId e, double t) { return corridor.on_edge(e, t); },
      [&](const SurfacePoint& p) { return corridor.at(p); },
      [&](FaceId f, const auto& b, const auto& d) { return corridor.in_face(f, b, d); },
  };
  const std::vector<SurfaceCurve> before = curves;
  for (SurfaceCurve& curve : curves) {
    polish(mesh, curve, exact, curve_options_.pins, options, progress);
  }
  // Each curve is polished for itself; where that made them cross they stay as they were.
  for (auto crossing = crossing_curves(mesh.surface(), curves); !crossing.empty();
       crossing = crossing_curves(mesh.surface(), curves)) {
    const bool again = std::all_of(crossing.begin(), crossing.end(), [&](std::size_t c) {
      return curves[c].points == before[c].points;
    });
    if (again) break;
    for (const std::size_t c : crossing) curves[c] = before[c];
  }
}

/// How far out δ must be exact where the valley is narrow: faces that the curve passes through lie
/// within the slack and an edge.
double CurveSmoother::exact_for(const std::vector<Corridor::Valley>& valleys) const {
  double exact = 0;
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    const double slack = largest_slack(valleys[c]);
    // While dragging there are valleys of curves that are only near.
    exact = std::max(exact,
                     slack + drawing_.edges_near()[std::min(c, drawing_.edges_near().size() - 1)]);
  }
  return exact;
}

Straightened CurveSmoother::straighten_in(const Corridor& corridor, const SmoothingOptions& options,
                                          double exact) {
  const std::size_t own = mesh_->surface().vertex_count();
  Asker asker(options.progress, "straighten");
  const AskedDuring asked(*exact_distance_, asker);
  Straightened result = straighten(options, [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {  // inserted vertices lie on the drawing
      return v.index() < own ? corridor.at_vertex_roughly(v, exact) : std::array<double, 2>{0, 0};
    };
    return lifted_length(length, at(p), at(q));
  });
  return result;
}

/// Without a lift.
Straightened CurveSmoother::straighten_flat(const SmoothingOptions& options) {
  return straighten(
      options, [](VertexId, VertexId, double length) { return lifted_length(length, 0.0, 0.0); });
}

/// Whether the lift would have changed one of the lengths that were looked at. Ways along their
/// edges from the drawing say how far away they are at most.
bool CurveSmoother::is_felt(const Corridor& corridor, const Straightened& flat,
                            const Progress& progress) const {
  const TouchedEdges edges =
      touched_edges(mesh_->surface(), flat.touched, drawing_.curves(), progress);
  return !(corridor.largest_lengthening(edges.farthest, edges.shortest) <= kUnfelt);
}

/// FlipOut sees the potential at the mesh's vertices. A loop that has none inside it collapses
/// whatever tau is; the polish, which looks closer, starts from its drawing instead.
void CurveSmoother::hold_thin_loops(Straightened& straight) const {
  for (std::size_t c = 0; c < capped_.size(); ++c) {
    FlipOutResult::Path& path = straight.flip_out.paths[c];
    if (!capped_[c].closed || path.termination != Termination::kCollapsed) continue;
    straight.curves[c] = drawing_.curves()[c];  // capped corners may cut through it
    path.length_after = path.length_before;
    path.termination = Termination::kConverged;
  }
}

/// Straightened once, at the origin; from there the polish alone goes down, from one power of two
/// to the next. So the result follows tau without jumping from one of several nearly equal
/// geodesics to another, and is the same whatever was asked before. Upwards the polish would not
/// find its way back over the ridges between two strands of the drawing: each anchor is
/// straightened for itself. What leads on is polished a little only; where curves start from an
/// anchor it is polished in full, apart from that.
CurveSmoother::Anchor& CurveSmoother::anchor_at(double tau, const SmoothingOptions& options,
                                                const std::vector<Corridor::Valley>& valleys,
                                                StageTimes& times) {
  const auto known = anchors_.find(tau);
  if (known != anchors_.end()) return known->second;
  const Corridor corridor(*exact_distance_, tau, valleys);
  Anchor anchor;
  if (tau >= kOrigin) {
    SmoothingOptions at_origin = options;
    at_origin.tau = tau;
    anchor.straight = straighten_in(corridor, at_origin, exact_for(valleys));
    hold_thin_loops(anchor.straight);
    anchor.rough = anchor.straight.curves;
    times.straighten = anchor.straight.time_ms.straighten;
    times.trace = anchor.straight.time_ms.trace;
  } else {
    const Anchor& above = anchor_at(2 * tau, options, valleys, times);
    anchor = {above.straight, above.rough, {}};
  }
  const Stopwatch watch;
  polish_in(corridor, anchor.rough, options.progress, kRough);
  times.polish += watch.ms();
  return anchors_.emplace(tau, std::move(anchor)).first->second;
}

SmoothingResult CurveSmoother::smooth_from_anchor(double from, const SmoothingOptions& options,
                                                  const std::vector<Corridor::Valley>& valleys) {
  const double floor = options.length_floor.value_or(default_floor());
  const bool whole = options.prepare_whole_mesh;  // its report differs
  if (whole || anchor_valleys_ != valleys || anchor_floor_ != floor) anchors_.clear();
  anchor_valleys_ = valleys;
  anchor_floor_ = floor;
  StageTimes times;
  Anchor& anchor = anchor_at(from, options, valleys, times);
  if (anchor.polished.empty()) {
    std::vector<SurfaceCurve> polished = anchor.rough;
    const Corridor corridor(*exact_distance_, from, valleys);
    const Stopwatch watch;
    polish_in(corridor, polished, options.progress);
    anchor.polished = std::move(polished);
    times.polish += watch.ms();
  }
  std::vector<SurfaceCurve> curves = anchor.polished;
  if (from != options.tau) {
    const Corridor corridor(*exact_distance_, options.tau, valleys);
    const Stopwatch watch;
    polish_in(corridor, curves, options.progress);
    times.polish += watch.ms();
  }
  SmoothingResult result = report_on(options, anchor.straight, std::move(curves), times);
  if (whole) anchors_.clear();
  return result;
}

/// The curve where nothing lifts it, which takes no distance; none where the lift is felt.
std::optional<Straightened> CurveSmoother::unlifted(const Corridor& corridor,
                                                    const std::vector<Corridor::Valley>& valleys,
                                                    const SmoothingOptions& options) {
  if (options.tau == 0) return straighten_flat(options);
  // A try is worth its time only if it would not be felt a sixteenth of the drawing's radius beyond
  // the slack.
  double beyond = HUGE_VAL, slack = 0;
  for (const Corridor::Valley& valley : valleys) {
    beyond = std::min(beyond, valley.length / 4);
    slack = std::max(slack, largest_slack(valley));
  }
  if (corridor.largest_lengthening(slack + beyond, beyond) > kUnfelt) return std::nullopt;
  SmoothingOptions lazy = options;
  lazy.prepare_whole_mesh = false;  // what it touches decides
  Straightened flat = straighten_flat(lazy);
  if (is_felt(corridor, flat, options.progress)) return std::nullopt;
  return options.prepare_whole_mesh ? straighten_flat(options) : std::move(flat);
}

SmoothingResult CurveSmoother::smooth_for_itself(const SmoothingOptions& options,
                                                 const std::vector<Corridor::Valley>& valleys) {
  const Corridor corridor(*exact_distance_, options.tau, valleys);
  const std::optional<Straightened> flat = unlifted(corridor, valleys, options);
  const Straightened straight = flat ? *flat : straighten_in(corridor, options, HUGE_VAL);
  std::vector<SurfaceCurve> curves = straight.curves;
  StageTimes times = straight.time_ms;
  Stopwatch watch;
  relax(mesh_->mesh(), curves, {options.relax_rounds}, options.progress);
  times.relax = watch.ms();
  watch = Stopwatch();
  if (options.polish && !flat) polish_in(corridor, curves, options.progress);
  times.polish = watch.ms();
  return report_on(options, straight, std::move(curves), times);
}

SmoothingResult CurveSmoother::smooth_in_corridor(const SmoothingOptions& options) {
  return smooth_in_valleys(options, valleys_for(options));
}

SmoothingResult CurveSmoother::smooth_in_valleys(const SmoothingOptions& options,
                                                 const std::vector<Corridor::Valley>& valleys) {
  const std::optional<double> from = anchor_of(options);
  SmoothingResult result =
      from ? smooth_from_anchor(*from, options, valleys) : smooth_for_itself(options, valleys);
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    report.potential = "corridor";
    report.engine = "local";
    report.slack = largest_slack(valleys[c]);
  }
  result.total = total_of(result.reports);
  last_->result = result;
  return result;
}

}  // namespace talweg

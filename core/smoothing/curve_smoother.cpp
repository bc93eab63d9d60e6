#include "talweg/core/smoothing/curve_smoother.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/smoothing/lifted_lengths.hpp"
#include "talweg/core/smoothing/refined_smoother.hpp"
#include "talweg/core/smoothing/relaxation.hpp"
#include "talweg/core/smoothing/unrolled_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfPoint = 8;  // units of work, to measure or to check it

/// The length where nothing is lifted, as the others are computed.
double flat_length(double length) { return lifted_length(length, 0.0, 0.0); }

[[noreturn]] void bad_usage(const std::string& message) {
  throw Error(ErrorCode::kBadUsage, message);
}

}  // namespace

CurveSmoother::CurveSmoother(std::shared_ptr<const OpenedMesh> mesh)
    : mesh_(std::move(mesh)), straightening_(mesh_->surface()), lift_(*mesh_, straightening_) {}

CurveSmoother::~CurveSmoother() = default;

void CurveSmoother::forget() {
  straightening_.clear();
  unrolled_.reset();
  refined_.clear();
  drawing_ = {};
  capped_.clear();
  lift_.clear();
  last_.reset();
  valleys_.clear();
  anchors_.clear();
  solve_ms_ = 0;
}

void CurveSmoother::take(std::span<const SurfaceCurve> curves, const CurveOptions& options,
                         const Progress& progress) {
  if (curves.empty()) bad_usage("There is no curve to smooth.");
  options.validate();
  const Surface& surface = mesh_->surface();
  Asker asker(progress, "embed");
  for (const SurfaceCurve& curve : curves) {
    asker.did(kOfPoint * curve.points.size());
    check_drawn(surface, curve);
  }
  check_pins(curves, options.pins);
  curve_options_ = options;
  drawing_ = OrderedDrawing(mesh_->mesh(), curves, asker);
}

void CurveSmoother::embed_drawn(const Progress& progress) {
  capped_.clear();
  for (const SurfaceCurve& curve : drawing_.curves()) {
    capped_.push_back(curve_options_.cap_corners
                          ? capped_curve(mesh_->surface(), curve, curve_options_.pins)
                          : curve);
  }
  straightening_.embed(capped_, curve_options_.pins, loops_, drawing_.numbers(), progress);
}

bool CurveSmoother::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  if (!is_set()) bad_usage("No curve is set.");
  if (curve_options_.method != Method::kCorridor) bad_usage("set_pins() needs the corridor.");
  check_pins(drawing_.drawn(), pins);
  const std::vector<SurfacePoint> own(pins.begin(), pins.end());  // may be our own
  const std::vector<SurfacePoint> before = curve_options_.pins;
  const auto set = [&](const std::vector<SurfacePoint>& these, const Progress& asked) {
    curve_options_.pins = these;
    if (!refined_.empty()) return set_refined_pins(asked);
    if (unrolled_) return set_unrolled_pins(asked);
    embed_drawn(asked);
    return true;
  };
  bool done = false;
  try {
    done = set(own, progress);
  } catch (const Cancelled&) {
  } catch (...) {
    set(before, {});
    throw;
  }
  if (!done) {
    set(before, {});
    return false;
  }
  if (!refined_.empty() || unrolled_) return true;
  anchors_.clear();
  last_.reset();
  return true;
}

bool CurveSmoother::set_curve(const SurfaceCurve& curve, const CurveOptions& options,
                              const Progress& progress) {
  return set_curves(std::span(&curve, 1), options, progress);
}

bool CurveSmoother::set_curves(std::span<const SurfaceCurve> curves, const CurveOptions& options,
                               const Progress& progress) {
  const std::vector<SurfaceCurve> own(curves.begin(), curves.end());  // may be our own drawing
  forget();
  try {
    take(own, options, progress);
    set_drawn(options, progress);
  } catch (const Cancelled&) {
    forget();
    return false;
  } catch (...) {
    forget();
    throw;
  }
  return true;
}

void CurveSmoother::set_drawn(const CurveOptions& options, const Progress& progress) {
  if (!faces_to_divide().empty()) {
    capped_ = drawing_.curves();
    return set_refined(progress);
  }
  embed_drawn(progress);
  if (const std::vector<bool> alone = tangled(); !alone.empty()) {
    set_unrolled(alone, progress);
  } else if (options.method == Method::kCorridor) {
    solve_corridor(progress);
  } else if (options.distance_at_once) {
    solve_distance(progress);
  }
}

bool CurveSmoother::set_curves(std::span<const SurfaceCurve> curves, std::vector<double> distance,
                               const CurveOptions& options, const Progress& progress) {
  const std::vector<SurfaceCurve> own(curves.begin(), curves.end());
  forget();
  const Stopwatch watch;
  PaperLift::check(mesh_->surface(), distance);
  try {
    take(own, options, progress);
    embed_drawn(progress);
    curve_options_.method = Method::kPaper;
    lift_.set(std::move(distance), drawing_.drawn().size() > 1);
    if (const std::vector<bool> alone = tangled(); !alone.empty()) {
      set_unrolled(alone, progress);
    }
  } catch (const Cancelled&) {
    forget();
    return false;
  } catch (...) {
    forget();
    throw;
  }
  solve_ms_ = watch.ms();
  return true;
}

void CurveSmoother::solve_corridor(const Progress& progress) {
  const Stopwatch watch;
  if (!exact_distance_) exact_distance_.emplace(mesh_->surface());
  {
    Asker asker(progress, "solve");
    const AskedDuring asked(*exact_distance_, asker);
    exact_distance_->set(drawing_.curves());
  }
  make_valleys(progress);
  hold_loops(progress);
  solve_ms_ = watch.ms();
}

bool CurveSmoother::need_distance(const Progress& progress) {
  if (!is_set()) bad_usage("No curve is set.");
  if (curve_options_.method != Method::kPaper || lift_.is_known()) return true;
  try {
    solve_distance(progress);
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

void CurveSmoother::solve_distance(const Progress& progress) {
  lift_.solve(capped_, curve_options_, progress);
  solve_ms_ = lift_.solve_ms();
}

double CurveSmoother::drawn_length() const {
  double length = 0;
  for (const CurveMeasures& m : drawing_.measures()) length += m.length;
  return length;
}

/// A loop of this length is a handful of edges around a vertex: three mean edges of the drawing,
/// but less than half a loop that is drawn so small.
double CurveSmoother::default_floor() const {
  double floor = HUGE_VAL;
  for (std::size_t c = 0; c < capped_.size(); ++c) {
    if (!capped_[c].closed) continue;
    const double length = curve_length(mesh_->surface(), capped_[c]);
    const double mean = length / static_cast<double>(capped_[c].points.size());
    floor = std::min({floor, 3 * mean, length / 2});
  }
  return std::isfinite(floor) ? floor : 0;
}

SmoothingResult CurveSmoother::smooth(double tau) {
  SmoothingOptions options;
  options.tau = tau;
  return smooth(options);
}

SmoothingResult CurveSmoother::smooth(const SmoothingOptions& options) {
  options.validate();
  if (!is_set()) bad_usage("No curve is set.");
  try {
    const Asker asked(options.progress, "straighten");
    return drawing_.as_drawn(smooth_now(with_ordered_slack(options)));
  } catch (const Cancelled&) {
    return cancelled_result(options);
  }
}

/// The drawing as it is.
SmoothingResult CurveSmoother::cancelled_result(const SmoothingOptions& options) const {
  SmoothingResult result;
  result.curves = drawing_.drawn();
  for (std::size_t c = 0; c < drawing_.drawn().size(); ++c) {
    SmoothingReport& report = result.reports.emplace_back(report_on_nothing(
        mesh_->mesh(), drawing_.drawn()[c], drawing_.measures()[drawing_.place_of(c)]));
    report.tau = options.tau;
    report.edge_length_near = drawing_.edges_near()[drawing_.place_of(c)];
    report.termination = to_string(Termination::kCancelled);
  }
  result.total = total_of(result.reports);
  return result;
}

SmoothingOptions CurveSmoother::with_ordered_slack(SmoothingOptions options) const {
  return curve_options_.method == Method::kCorridor ? drawing_.ordered(std::move(options))
                                                    : options;
}

SmoothingResult CurveSmoother::smooth_now(const SmoothingOptions& options) {
  if (!refined_.empty()) return smooth_refined(options);
  if (unrolled_) return smooth_unrolled(options);
  if (curve_options_.method == Method::kCorridor) return smooth_in_corridor(options);
  return smooth_for_paper(options);
}

SmoothingResult CurveSmoother::smooth_for_paper(const SmoothingOptions& options) {
  if (options.tau == 0) {
    return run(options, [](VertexId, VertexId, double length) { return flat_length(length); });
  }
  if (!need_distance(options.progress)) throw Cancelled();
  return run(options, lift_.metric(options.potential, options.tau, drawn_length()));
}

SmoothingResult CurveSmoother::smooth(const SmoothingOptions& options,
                                      std::span<const double> potential, std::size_t components) {
  options.validate();
  if (!is_set()) bad_usage("No curve is set.");
  const std::size_t own = mesh_->surface().vertex_count();
  if (components == 0 || potential.size() != own * components) {
    bad_usage("A potential of " + std::to_string(components) + " components needs " +
              std::to_string(own * components) + " values, not " +
              std::to_string(potential.size()) + ".");
  }
  for (std::size_t i = 0; i < potential.size(); ++i) {
    if (!(std::abs(potential[i]) <= 1e150)) {
      bad_usage("The potential of vertex " + std::to_string(i / components) +
                " is not a number of at most 1e150.");
    }
  }
  try {
    const Asker asked(options.progress, "straighten");
    return drawing_.as_drawn(smooth_now(options, potential, components));
  } catch (const Cancelled&) {
    return cancelled_result(options);
  }
}

SmoothingResult CurveSmoother::smooth_now(const SmoothingOptions& options,
                                          std::span<const double> potential,
                                          std::size_t components) {
  if (!refined_.empty()) return smooth_refined(options, potential, components);
  if (unrolled_) return smooth_unrolled(options, potential, components);
  const std::size_t own = mesh_->surface().vertex_count();
  const std::vector<double> inserted = straightening_.at_inserted(potential, components);
  SmoothingResult result = run(options, [&](VertexId p, VertexId q, double length) {
    const auto at = [&](VertexId v) {
      return v.index() < own
                 ? potential.subspan(v.index() * components, components)
                 : std::span(inserted).subspan((v.index() - own) * components, components);
    };
    return lifted_length(length, at(p), at(q));
  });
  for (SmoothingReport& report : result.reports) report.potential = "custom";
  result.total.potential = "custom";
  return result;
}

SmoothingResult CurveSmoother::run(const SmoothingOptions& options,
                                   SignpostTriangulation::Metric metric) {
  const Straightened straight = straighten(options, std::move(metric));
  const Stopwatch watch;
  std::vector<SurfaceCurve> curves = straight.curves;
  relax(mesh_->mesh(), curves, {options.relax_rounds}, options.progress);
  StageTimes times = straight.time_ms;
  times.relax = watch.ms();
  return report_on(options, straight, std::move(curves), times);
}

Straightened CurveSmoother::straighten(const SmoothingOptions& options,
                                       SignpostTriangulation::Metric metric) {
  Straightening::Options own;
  own.flip_out.max_iterations = options.max_iterations;
  own.flip_out.min_relative_length = options.min_relative_length;
  own.flip_out.length_floor = options.length_floor.value_or(default_floor());
  own.flip_out.progress = options.progress;
  own.prepare_whole_mesh = options.prepare_whole_mesh;
  Straightened result = straightening_.run(std::move(metric), std::move(own));
  const auto is_cut = [&](VertexId v) { return v.index() < cut_->size() && (*cut_)[v.index()]; };
  at_cut_ = at_cut_ ||
            (cut_ != nullptr && std::any_of(result.touched.begin(), result.touched.end(), is_cut));
  return result;
}

DeviationMeasure CurveSmoother::measure_for(const SmoothingOptions& options) {
  const bool automatic = options.deviation == DeviationMeasure::kAutomatic;
  return automatic && options.tau >= kLeastAnchor ? DeviationMeasure::kAlongSurface
                                                  : options.deviation;
}

SmoothingResult CurveSmoother::report_on(const SmoothingOptions& options,
                                         const Straightened& straight,
                                         std::vector<SurfaceCurve> curves, StageTimes times) {
  SmoothingResult result;
  result.curves = std::move(curves);
  times.open = mesh_->open_ms() + lift_.open_ms();
  times.solve = solve_ms_;
  times.total =
      times.open + times.solve + times.straighten + times.trace + times.relax + times.polish;
  const bool band_is_there =
      curve_options_.method == Method::kCorridor && drawing_.drawn().size() == 1;
  if (!deviation_meter_) deviation_meter_.emplace(mesh_->mesh());
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    SmoothingReport& report = result.reports.emplace_back(report_on_curve(
        mesh_->mesh(), drawing_.curves()[c], drawing_.measures()[c], result.curves[c]));
    const FlipOutResult::Path& path = straight.flip_out.paths[c];
    report.tau = options.tau;
    report.edge_length_near = drawing_.edges_near()[c];
    report.lifted_length_before = path.length_before;
    report.lifted_length_after = path.length_after;
    report.termination = to_string(path.termination);
    report.flips = straight.flip_out.flips;
    report.iterations = straight.flip_out.iterations;
    report.faces_touched = straight.faces_touched;
    report.trace_fallbacks = straight.clamped;
    report.mollification = lift_.mollification();
    report.warnings = lift_.warnings();
    report_deviation(report, measure_for(options), *deviation_meter_, mesh_->mesh(),
                     drawing_.curves()[c], result.curves[c],
                     band_is_there ? &*exact_distance_ : nullptr, options.progress);
    if (warns_if_far_) {
      warn_if_far(report, kFarInEdges * drawing_.edges_near()[c],
                  options.deviation == DeviationMeasure::kAutomatic);
    }
    if (path.termination == Termination::kLimit && options.max_iterations == 0 &&
        options.min_relative_length == 0) {
      report.warnings.emplace_back(
          "Straightening was given up before the curve was straight: the drawing has too many "
          "points for so few faces.");
    }
    if (path.termination == Termination::kCollapsed) {
      report.warnings.emplace_back(
          "The loop shrinks to a point; it is returned as it was when it fell below the floor.");
    }
    if (straight.flip_out.blocked > 0) {
      report.warnings.emplace_back("The curve stays bent at " +
                                   std::to_string(straight.flip_out.blocked) +
                                   " points where another part of the drawing is in the way.");
    }
    report.time_ms = times;
    report.peak_memory_mib = peak_memory_mib();
  }
  report_moves(options, result);
  result.total = total_of(result.reports);
  return result;
}

/// A slider moves tau in small steps; the result should follow in small ones.
void CurveSmoother::report_moves(const SmoothingOptions& options, SmoothingResult& result) {
  constexpr double kSmallStep = 1.05;
  const auto near = [&](const SmoothingOptions& last) {
    const double least = std::min(last.tau, options.tau), most = std::max(last.tau, options.tau);
    return least > 0 && most <= kSmallStep * least && last.slack == options.slack &&
           last.slack_at == options.slack_at && last.phase_turns == options.phase_turns &&
           last.polish == options.polish && last.relax_rounds == options.relax_rounds;
  };
  if (last_ && options.deviation != DeviationMeasure::kNone && near(last_->options)) {
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
      report_move(result.reports[c], mesh_->mesh(), last_->options.tau, last_->result.curves[c],
                  result.curves[c], options.progress);
    }
  }
  last_ = Last{options, result};
  last_->options.progress = {};
}

SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options, const CurveOptions& curve_options) {
  CurveSmoother smoother(std::move(mesh));
  if (!smoother.set_curve(curve, curve_options, options.progress)) {
    SmoothingResult cancelled;
    cancelled.curves.push_back(curve);
    cancelled.reports.emplace_back();
    cancelled.reports.back().termination = to_string(Termination::kCancelled);
    cancelled.total = cancelled.reports.back();
    return cancelled;
  }
  return smoother.smooth(options);
}

std::vector<double> slack_along(const Surface& surface, const SurfaceCurve& drawn,
                                std::span<const double> per_vertex) {
  if (per_vertex.size() != surface.vertex_count()) {
    bad_usage("There are " + std::to_string(per_vertex.size()) + " slacks for " +
              std::to_string(surface.vertex_count()) + " vertices.");
  }
  std::vector<double> along;
  for (const SurfacePoint& point : drawn.points) {
    const FaceCoordinates at = coordinates_in(surface, point, any_face(surface, point));
    const auto corners = surface.corners(at.face);
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (at.barycentric[k] == 0) continue;
      const double here = per_vertex[corners[k].index()];
      if (!(here >= 0 && std::isfinite(here))) {
        bad_usage("The slack of vertex " + std::to_string(corners[k].index()) +
                  " must be finite and >= 0.");
      }
      value += at.barycentric[k] * here;
    }
    along.push_back(value);
  }
  return along;
}

SurfaceCurve curve_through(const Surface& surface, std::span<const VertexId> vertices) {
  SurfaceCurve curve;
  curve.closed = vertices.size() > 1 && vertices.front() == vertices.back();
  if (curve.closed) vertices = vertices.first(vertices.size() - 1);
  for (const VertexId v : vertices) curve.points.push_back(SurfacePoint::at_vertex(surface, v));
  check_drawn(surface, curve);
  return curve;
}

}  // namespace talweg

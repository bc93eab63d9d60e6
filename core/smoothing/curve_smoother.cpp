#include "talweg/core/smoothing/curve_smoother.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/mesh/smooth_ground.hpp"
#include "talweg/core/smoothing/cleaned_drawing.hpp"
#include "talweg/core/smoothing/domain_choice.hpp"
#include "talweg/core/smoothing/dragging.hpp"
#include "talweg/core/smoothing/missed_points.hpp"
#include "talweg/core/smoothing/smoothing_domain.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_report.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_usage(const std::string& message) {
  throw Error(ErrorCode::kBadUsage, message);
}

/// Throws Error(kBadUsage) unless every vertex has all components, each a number of at most 1e150.
void check_potential(std::size_t vertices, const GivenPotential& given) {
  const std::size_t expected = vertices * given.components;
  if (given.components == 0 || given.values.size() != expected) {
    bad_usage(fmt::format("A potential of {} components needs {} values, not {}.", given.components,
                          expected, given.values.size()));
  }
  for (std::size_t i = 0; i < given.values.size(); ++i) {
    if (std::abs(given.values[i]) <= 1e150) continue;
    bad_usage(fmt::format("The potential of vertex {} is not a number of at most 1e150.",
                          i / given.components));
  }
}

bool same_result(const SmoothingOptions& a, const SmoothingOptions& b) {
  return a.tau == b.tau && a.slack == b.slack && a.slack_at == b.slack_at &&
         a.per_curve == b.per_curve && a.phase_turns == b.phase_turns && a.finish == b.finish &&
         a.relax_rounds == b.relax_rounds && a.max_iterations == b.max_iterations &&
         a.min_relative_length == b.min_relative_length && a.length_floor == b.length_floor;
}

/// Whether only tau has changed for a curve, by at most 5 %, a small step of a slider.
bool is_small_step(const SmoothingOptions& last, const SmoothingOptions& options,
                   std::size_t curve) {
  constexpr double kSmallStep = 1.05;
  const double least = std::min(last.tau_of(curve), options.tau_of(curve));
  const double most = std::max(last.tau_of(curve), options.tau_of(curve));
  return least > 0 && most <= kSmallStep * least &&
         last.slack_of(curve) == options.slack_of(curve) && last.slack_at == options.slack_at &&
         last.phase_turns == options.phase_turns &&
         last.finish_of(curve) == options.finish_of(curve) &&
         last.relax_rounds == options.relax_rounds;
}

/// Progress with the budget of the options, which begins with this call; without one, the caller's
/// progress.
Progress within_budget(const Progress& caller, const SmoothingOptions& options) {
  return options.budget.any() ? caller.with(options.budget) : caller;
}

}  // namespace

struct CurveSmoother::Last {
  SmoothingOptions options;
  SmoothingResult result;
  bool whole = true;  ///< false if a budget ended the smoothing early
};

CurveSmoother::CurveSmoother(std::shared_ptr<const OpenedMesh> mesh)
    : memory_(std::make_unique<SmoothingMemory>(std::move(mesh))),
      cleaned_(std::make_unique<CleanedDrawing>()),
      drawing_(std::make_unique<OrderedDrawing>()) {}

CurveSmoother::~CurveSmoother() = default;

const OpenedMesh& CurveSmoother::opened() const { return memory_->opened(); }

void CurveSmoother::forget() {
  domain_.reset();
  memory_->straightening().clear();
  given_.clear();
  *cleaned_ = {};
  *drawing_ = {};
  last_.reset();
}

bool CurveSmoother::set_curve(const SurfaceCurve& curve, const CurveOptions& options,
                              const Progress& progress) {
  return set_curves(std::span(&curve, 1), options, progress);
}

bool CurveSmoother::set_curve(const Drawing& drawing, const CurveOptions& options,
                              const Progress& progress) {
  CurveOptions own = options;
  own.way_points.insert(own.way_points.end(), drawing.way_points.begin(), drawing.way_points.end());
  return set_curve(drawing.curve, own, progress);
}

bool CurveSmoother::set_curves(std::span<const SurfaceCurve> curves, const CurveOptions& options,
                               const Progress& progress) {
  return set(curves, options, std::nullopt, progress);
}

bool CurveSmoother::set_curves(std::span<const SurfaceCurve> curves, std::vector<double> distance,
                               const CurveOptions& options, const Progress& progress) {
  CurveOptions own = options;
  own.method = Method::kPaper;
  return set(curves, own, std::move(distance), progress);
}

bool CurveSmoother::set(std::span<const SurfaceCurve> curves, const CurveOptions& options,
                        std::optional<std::vector<double>> distance, const Progress& progress) {
  const std::vector<SurfaceCurve> own(curves.begin(), curves.end());  // `curves` may be drawn()
  forget();
  if (distance) PaperLift::check(memory_->surface(), *distance);
  try {
    check_drawing(memory_->mesh(), own, options, progress);
    *cleaned_ = cleaned_drawing(memory_->mesh(), own, options, {}, progress);
    CurveOptions cleaned = options;
    cleaned.painted = cleaned_->painted;
    cleaned.way_points = cleaned_->way_points;
    *drawing_ =
        checked_drawing(memory_->mesh(), cleaned_->drawn(), cleaned_->slacks(), cleaned, progress);
    given_ = own;
    curve_options_ = options;
    roughness_ = options.method == Method::kCorridor
                     ? roughness_along(memory_->mesh(), drawing_->curves(), progress)
                     : HUGE_VAL;
    domain_ = domain_for(*memory_, *drawing_, cleaned, std::move(distance), roughness_, progress);
  } catch (const Cancelled&) {
    forget();
    return false;
  } catch (...) {
    forget();
    throw;
  }
  return true;
}

bool CurveSmoother::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  if (!domain_) bad_usage("No curve is set.");
  if (curve_options_.method != Method::kCorridor) bad_usage("set_pins() needs the corridor.");
  check_pins(given_, pins);
  CurveOptions options = curve_options_;
  options.pins.assign(pins.begin(), pins.end());
  try {
    if (!is_cleaned_alike(options, progress)) return set_anew(options, progress);
  } catch (const Cancelled&) {
    return false;
  }
  try {
    domain_->set_pins(options.pins, progress);
  } catch (const Cancelled&) {
    domain_->set_pins(curve_options_.pins, {});
    return false;
  } catch (...) {
    domain_->set_pins(curve_options_.pins, {});
    throw;
  }
  curve_options_.pins = std::move(options.pins);
  last_.reset();
  return true;
}

/// Whether the cleaning of the given curves removes the same points with other pins: a pin may
/// divide a rest. The slack of strokes depends on the pins only if way-points make legs.
bool CurveSmoother::is_cleaned_alike(const CurveOptions& options, const Progress& progress) const {
  const std::vector<StrokeSlack> known =
      options.way_points.empty() ? cleaned_->slacks() : std::vector<StrokeSlack>();
  return is_same(cleaned_drawing(memory_->mesh(), given_, options, known, progress), *cleaned_);
}

/// Sets the given curves with other pins. If this fails or is cancelled, the smoother is unchanged.
bool CurveSmoother::set_anew(const CurveOptions& options, const Progress& progress) {
  const std::vector<SurfaceCurve> given = given_;
  const CurveOptions before = curve_options_;
  try {
    if (set(given, options, std::nullopt, progress)) return true;
  } catch (...) {
    set(given, before, std::nullopt, {});
    throw;
  }
  set(given, before, std::nullopt, {});
  return false;
}

bool CurveSmoother::need_distance(const Progress& progress) {
  if (!domain_) bad_usage("No curve is set.");
  try {
    domain_->need_distance(progress);
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

std::span<const double> CurveSmoother::distance() const {
  return domain_ ? domain_->distance() : std::span<const double>{};
}

std::span<const SurfaceCurve> CurveSmoother::drawn() const { return given_; }

std::vector<double> CurveSmoother::slack() const {
  if (!domain_) return {};
  const std::vector<double> ordered = domain_->slack();
  return ordered.empty() ? ordered : drawing_->in_drawn_order(ordered);
}

SmoothingResult CurveSmoother::smooth(double tau) {
  SmoothingOptions options;
  options.tau = tau;
  return smooth(options);
}

SmoothingResult CurveSmoother::smooth(const SmoothingOptions& options, const Progress& progress) {
  check(options);
  return smooth(options, nullptr, progress);
}

SmoothingResult CurveSmoother::smooth(const SmoothingOptions& options,
                                      std::span<const double> potential, std::size_t components,
                                      const Progress& progress) {
  check(options);
  if (!options.per_curve.empty()) bad_usage("per_curve cannot be used with a given potential.");
  const GivenPotential given{potential, components};
  check_potential(memory_->surface().vertex_count(), given);
  return smooth(options, &given, progress);
}

/// Options with slack_at converted from the given curves to the cleaned curves.
SmoothingOptions CurveSmoother::on_cleaned(SmoothingOptions options) const {
  for (std::size_t c = 0; c < options.slack_at.size() && c < given_.size(); ++c) {
    std::vector<double>& values = options.slack_at[c];
    if (values.size() != given_[c].points.size()) continue;
    values = cleaned_->curves[c].values(values, given_[c].closed);
  }
  return options;
}

/// A moved curve, cleaned with the slack of the curve that is set.
SurfaceCurve CurveSmoother::cleaned_as(std::size_t curve, const SurfaceCurve& moved,
                                       const Progress& progress) const {
  const std::span known(&cleaned_->curves[curve].slack, 1);
  return cleaned_drawing(memory_->mesh(), std::span(&moved, 1), curve_options_, known, progress)
      .curves[0]
      .curve;
}

void CurveSmoother::check(const SmoothingOptions& options) const {
  options.validate();
  if (!domain_) bad_usage("No curve is set.");
  const bool corridor = curve_options_.method == Method::kCorridor;
  if (!corridor && !options.per_curve.empty()) bad_usage("per_curve needs the corridor.");
}

SmoothingResult CurveSmoother::smooth(const SmoothingOptions& options, const GivenPotential* given,
                                      const Progress& caller) {
  const Progress progress = within_budget(caller, options);
  try {
    const ProgressPoller polled(progress, "straighten");
    return drawing_->as_drawn(smooth_ordered(
        ordered_for(curve_options_.method, *drawing_, on_cleaned(options)), given, progress));
  } catch (const Cancelled&) {
    SmoothingResult result = cancelled_result(memory_->mesh(), *drawing_, options);
    result.curves = given_;
    return result;
  }
}

/// Smooths with options and results in canonical order.
SmoothingResult CurveSmoother::smooth_ordered(const SmoothingOptions& options,
                                              const GivenPotential* given,
                                              const Progress& progress) {
  DomainResult smoothed = domain_->smooth(options, given, progress);
  const SurfaceMesh* ground = smoothed.ground;
  const Stopwatch watch;
  SmoothingResult result = reported(memory_->opened(), *drawing_, options, std::move(smoothed));
  CurveOptions cleaned = curve_options_;
  cleaned.way_points = cleaned_->way_points;
  warn_of_missed_points(memory_->mesh(), memory_->meter(), drawing_->curves(), cleaned, result);
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    const std::size_t given_number = drawing_->numbers()[c];
    report_cleaning(cleaned_->curves[given_number], given_[given_number], ground,
                    result.reports[c]);
    result.reports[c].roughness_near = roughness_;
  }
  report_moves(options, result, progress);
  const double ms = watch.ms();
  for (SmoothingReport& report : result.reports) {
    report.time_ms.measure += ms;
    report.time_ms.total += ms;
  }
  result.total = total_of(result.reports);
  last_ = std::make_unique<Last>(Last{options, result, !has_ended_early(progress)});
  return result;
}

/// Reports how far each curve moved in a small step of tau, because results should then move
/// little, too.
void CurveSmoother::report_moves(const SmoothingOptions& options, SmoothingResult& result,
                                 const Progress& progress) const {
  if (!last_ || !last_->whole || options.deviation == DeviationMeasure::kNone) return;
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    if (!is_small_step(last_->options, options, c)) continue;
    report_move(result.reports[c], memory_->mesh(), last_->options.tau_of(c),
                last_->result.curves[c], result.curves[c], progress);
  }
}

SmoothingResult CurveSmoother::drag(std::size_t curve, const SurfaceCurve& moved,
                                    const SmoothingOptions& options, const Progress& progress) {
  return drag(curve, Drawing{moved, {}}, options, progress);
}

SmoothingResult CurveSmoother::drag(std::size_t curve, const Drawing& moved,
                                    const SmoothingOptions& given, const Progress& caller) {
  check(given);
  const SmoothingOptions options = on_cleaned(given);
  const Progress progress = within_budget(caller, options);
  if (curve_options_.method != Method::kCorridor) bad_usage("drag() needs the corridor.");
  if (curve >= drawing_->drawn().size()) bad_usage("drag() is asked for a curve that is not set.");
  const Drawing own = moved;  // NOLINT: `moved` may refer to drawn(), which changes
  check_drawn(memory_->surface(), own.curve);
  try {
    const ProgressPoller polled(progress, "straighten");
    const bool by_stretch = domain_->valleys() != nullptr && curve_options_.way_points.empty() &&
                            own.way_points.empty();
    return by_stretch ? drag_now(curve, cleaned_as(curve, own.curve, progress), options, progress)
                      : drag_whole(curve, own, options, progress);
  } catch (const Cancelled&) {
    SmoothingResult result = cancelled_result(memory_->mesh(), *drawing_, options);
    result.curves = given_;
    result.curves[curve] = own.curve;
    return result;
  }
}

/// The last result, recomputed if it was for other options.
SmoothingResult CurveSmoother::last_for(const SmoothingOptions& options, const Progress& progress) {
  SmoothingOptions plain = drawing_->ordered(options);
  if (!last_ || !last_->whole || !same_result(last_->options, plain)) {
    plain.deviation = DeviationMeasure::kNone;
    smooth_ordered(plain, nullptr, progress);
  }
  return drawing_->as_drawn(last_->result);
}

SmoothingResult CurveSmoother::drag_now(std::size_t curve, const SurfaceCurve& moved,
                                        const SmoothingOptions& options, const Progress& progress) {
  SmoothingResult result = last_for(options, progress);
  const Stopwatch watch;
  const DrawingChange change = change_between(drawing_->drawn()[curve], moved);
  if (!change.is_none()) {
    if (!dragging_) dragging_ = std::make_unique<Dragging>(memory_->shared());
    result.curves[curve] =
        dragging_->dragged({*drawing_, curve_options_, *domain_->valleys(), options}, curve, change,
                           result.curves[curve], progress);
  }
  const double fair_ms = watch.ms();
  SmoothingReport& report = result.reports[curve];
  report = preview_report(memory_->mesh(), memory_->meter(), moved, result.curves[curve],
                          options.of(curve), report, progress);
  report.time_ms.fair = fair_ms;
  report.time_ms.total = watch.ms();
  report.time_ms.measure = report.time_ms.total - report.time_ms.fair;
  result.total = total_of(result.reports);
  return result;
}

/// The curve options after one of the curves has moved, with its new way-points.
CurveOptions CurveSmoother::options_of_moved(std::span<const SurfaceCurve> curves,
                                             std::size_t moved,
                                             std::span<const WayPoint> way_points) const {
  CurveOptions own = curve_options_;
  PointLookup others, here, is_new;
  for (std::size_t c = 0; c < curves.size(); ++c)
    (c == moved ? here : others).add_all(curves[c].points);
  for (const WayPoint& way : way_points) is_new.add(way.point);
  const auto is_gone = [&](const SurfacePoint& point) {
    return !here.contains(point) && !others.contains(point);
  };
  std::erase_if(own.pins, is_gone);
  std::erase_if(own.corners, is_gone);
  std::erase_if(own.painted, is_gone);
  // An old place of a moved click may still lie on the path, but is not a way-point.
  const auto is_left = [&](const SurfacePoint& point) {
    return !way_points.empty() && !others.contains(point);
  };
  std::erase_if(own.way_points, [&](const WayPoint& way) {
    return is_gone(way.point) || is_left(way.point) || is_new.contains(way.point);
  });
  own.way_points.insert(own.way_points.end(), way_points.begin(), way_points.end());
  return own;
}

/// Smooths all curves again, if a stretch cannot be smoothed alone: with legs, unrolled strips or
/// divided faces.
SmoothingResult CurveSmoother::drag_whole(std::size_t curve, const Drawing& moved,
                                          const SmoothingOptions& options,
                                          const Progress& progress) {
  std::vector<SurfaceCurve> curves = given_;
  curves[curve] = moved.curve;
  const CurveOptions own = options_of_moved(curves, curve, moved.way_points);
  SmoothingOptions plain = options;
  plain.slack_at.clear();  // its values belong to the drawing that is set
  if (!previewer_) previewer_ = std::make_unique<CurveSmoother>(memory_->shared());
  if (!previewer_->set_curves(curves, own, progress)) throw Cancelled();
  SmoothingResult result = previewer_->drawing_->as_drawn(previewer_->smooth_ordered(
      previewer_->drawing_->ordered(std::move(plain)), nullptr, progress));
  result.reports[curve].engine = Engine::kPreview;
  result.total = total_of(result.reports);
  return result;
}

SmoothingResult smooth_curve(std::shared_ptr<const OpenedMesh> mesh, const SurfaceCurve& curve,
                             const SmoothingOptions& options, const CurveOptions& curve_options,
                             const Progress& progress) {
  CurveSmoother smoother(std::move(mesh));
  if (!smoother.set_curve(curve, curve_options, progress)) {
    SmoothingResult cancelled;
    cancelled.curves.push_back(curve);
    cancelled.reports.emplace_back();
    cancelled.reports.back().termination = Outcome::kCancelled;
    cancelled.total = cancelled.reports.back();
    return cancelled;
  }
  return smoother.smooth(options, progress);
}

}  // namespace talweg

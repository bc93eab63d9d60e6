#include "smooth_run.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "field_file.hpp"
#include "methods/smooth/smooth_parameters.hpp"
#include "output_file.hpp"
#include "shared_work.hpp"
#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/drawing/marked_points.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::driver {

namespace {

/// The median time of each stage over several runs with the same result.
StageTimes median_times(const std::vector<StageTimes>& runs) {
  StageTimes times;
  for (double StageTimes::*stage : {&StageTimes::load, &StageTimes::open, &StageTimes::solve,
                                    &StageTimes::straighten, &StageTimes::trace, &StageTimes::relax,
                                    &StageTimes::fair, &StageTimes::measure, &StageTimes::total}) {
    std::vector<double> values;
    values.reserve(runs.size());
    for (const StageTimes& run : runs) values.push_back(run.*stage);
    std::sort(values.begin(), values.end());
    times.*stage = values[values.size() / 2];
  }
  return times;
}

/// The input of a smoothing: the options with all their files read.
struct Prepared {
  std::vector<SurfaceCurve> curves;
  std::vector<SurfacePoint> pins, corners;  ///< points of the curves
  MarkedPoints points;
  std::vector<RidgeMoves> ridges;   ///< per curve; empty unless ridges attract the drawing
  std::vector<double> distance;     ///< per vertex; empty unless given
  std::vector<double> slack_field;  ///< per vertex; empty unless given
  const SmoothOptions* options = nullptr;
  CoordinateFrame frame;  ///< the frame of the mesh
  Progress progress;
  std::vector<std::string> warnings;
  SnappedDrawing moved;  ///< without its curves and pins
  double load_ms = 0;
  double opened_ms = 0;  ///< the time of reading and opening all files
};

/// The point of the mesh at a vertex of the file. Of a split vertex, the copy on a curve is chosen.
SurfacePoint pin_on(const std::vector<SurfaceCurve>& curves, const MeshFromFile& mesh,
                    VertexId pin) {
  const Surface& surface = mesh.mesh().surface();
  if (mesh.map == nullptr || pin.index() >= mesh.map->file_vertex_count()) {
    return SurfacePoint::at_vertex(surface, pin);
  }
  const auto images = mesh.map->images(pin);
  for (const std::uint32_t image : images) {
    const SurfacePoint point = SurfacePoint::at_vertex(surface, VertexId{image});
    for (const SurfaceCurve& curve : curves) {
      if (std::find(curve.points.begin(), curve.points.end(), point) != curve.points.end()) {
        return point;
      }
    }
  }
  return SurfacePoint::at_vertex(surface, VertexId{images.front()});
}

/// Converts one number per vertex of the file to one per vertex of the mesh.
std::vector<double> field_on(const MeshFromFile& mesh, const std::string& path) {
  if (mesh.map == nullptr) return read_field(path, mesh.mesh().surface().vertex_count());
  return mesh.map->of_vertices(read_field(path, mesh.map->file_vertex_count()));
}

/// Finds the way-points and the painted points among the points of the drawing.
void mark_points_of(const SnappedDrawing& drawing, const MeshFromFile& mesh,
                    const SmoothOptions& options, Prepared& run) {
  const PointsChoice choice = points_choice(options);
  PointOptions reading{plugins::point_meaning(choice.points), {}, options.tolerance};
  for (const std::size_t v : choice.exact) {
    reading.exact.push_back(pin_on(drawing.curves, mesh, VertexId{v}));
  }
  run.points = marked_points(drawing, reading);
  for (std::string& warning : stroke_warnings(drawing, reading)) {
    run.warnings.push_back(std::move(warning));
  }
}

/// Moves the curves and their points onto ridges; pins and corners stay.
void snap_to_ridges(const SurfaceMesh& mesh, const SmoothOptions& options, Prepared& run) {
  if (options.ridges.strength == 0) return;
  std::vector<SurfacePoint> fixed = run.pins;
  fixed.insert(fixed.end(), run.corners.begin(), run.corners.end());
  RidgedDrawing ridged = snapped_to_ridges(mesh, run.curves, fixed, std::move(run.points),
                                           options.ridges.options(), run.progress);
  run.curves = std::move(ridged.curves);
  run.points = std::move(ridged.points);
  run.ridges = std::move(ridged.moves);
  for (std::size_t c = 0; c < run.ridges.size(); ++c) {
    run.warnings.push_back(run.ridges[c].sentence(c));
  }
}

Prepared prepare(const MeshFromFile& mesh, DrawingReader& reader, const SmoothOptions& options,
                 const Progress& progress) {
  const Stopwatch watch;
  const Surface& surface = mesh.mesh().surface();
  std::optional<ExtendedCurves> extended;
  if (border_ends(options.border) == BorderEnds::kSnap) extended = ExtendedCurves::kStrokes;
  reader.set_ends(curve_ends(options.ends), extended);
  SnappedDrawing drawing =
      options.labels.empty()
          ? reader.read(options.curves, with_unit(mesh.frame, options.mesh_units), progress)
          : drawing_of_labels(options.labels, surface, mesh.map.get());
  Prepared run;
  run.options = &options;
  run.frame = with_unit(mesh.frame, options.mesh_units);
  run.progress = progress;
  run.load_ms = mesh.load_ms;
  check_lists(options, drawing.curves.size());
  run.warnings = reading_warnings(drawing, mesh.polygons);
  run.warnings.insert(run.warnings.end(), mesh.changes.begin(), mesh.changes.end());
  for (const std::size_t pin : options.pins) {
    drawing.pins.push_back(pin_on(drawing.curves, mesh, VertexId{pin}));
  }
  check_pins(drawing.curves, drawing.pins);
  for (const std::size_t corner : options.corners) {
    run.corners.push_back(pin_on(drawing.curves, mesh, VertexId{corner}));
  }
  check_pins(drawing.curves, run.corners, "corner");
  mark_points_of(drawing, mesh, options, run);
  run.curves = std::move(drawing.curves);
  run.pins = std::move(drawing.pins);
  snap_to_ridges(mesh.mesh(), options, run);
  if (!options.distance.empty()) {
    run.distance = field_on(mesh, options.distance);
  }
  if (!options.slack_field.empty()) {
    run.slack_field = field_on(mesh, options.slack_field);
  }
  run.moved = std::move(drawing);
  run.opened_ms = mesh.load_ms + mesh.opened->open_ms() + watch.ms();
  return run;
}

/// The input of one curve alone.
Prepared alone(const Prepared& run, std::size_t curve) {
  Prepared one;
  one.curves = {run.curves[curve]};
  const std::vector<SurfacePoint>& points = one.curves.front().points;
  const auto passed = [&](const SurfacePoint& p) {
    return std::find(points.begin(), points.end(), p) != points.end();
  };
  std::copy_if(run.pins.begin(), run.pins.end(), std::back_inserter(one.pins), passed);
  std::copy_if(run.corners.begin(), run.corners.end(), std::back_inserter(one.corners), passed);
  std::copy_if(run.points.way_points.begin(), run.points.way_points.end(),
               std::back_inserter(one.points.way_points),
               [&](const WayPoint& way) { return passed(way.point); });
  std::copy_if(run.points.painted.begin(), run.points.painted.end(),
               std::back_inserter(one.points.painted), passed);
  if (!run.ridges.empty()) one.ridges = {run.ridges[curve]};
  one.distance = run.distance;
  one.slack_field = run.slack_field;
  one.options = run.options;
  one.frame = run.frame;
  one.progress = run.progress;
  one.warnings = run.warnings;
  one.moved = run.moved;
  one.load_ms = run.load_ms;
  one.opened_ms = run.opened_ms;
  return one;
}

/// Throws plugin::Failure for a value out of range.
void set_field(plugin::Parameters& parameters, const char* id, const std::vector<double>& values) {
  const talweg_array array = plugin::view(values.data(), values.size());
  parameters.set_array(id, &array);
}

/// Sets a parameter from one value, or from one value per curve. Throws plugin::Failure.
void set_lists(plugin::Parameters& parameters, const SmoothOptions& o) {
  if (o.tau.size() == 1) {
    parameters.set_number("tau", o.tau.front());
  } else {
    set_field(parameters, "taus", o.tau);
  }
  if (o.slack.size() == 1 && o.slack.front() >= 0) {
    parameters.set_number("slack", o.slack.front());
  } else if (o.slack.size() > 1) {
    set_field(parameters, "slacks", o.slack);
  }
  if (o.finish.size() == 1) return parameters.set_choice("finish", o.finish.front().c_str());
  std::vector<double> finishes;
  for (const std::string& finish : o.finish) finishes.push_back(finish == "fair" ? 0 : 1);
  set_field(parameters, "finishes", finishes);
}

/// Converts the options to parameters of talweg.smooth. Throws plugin::Failure.
plugin::Parameters parameters_of(const Prepared& run) {
  plugin::Parameters parameters(plugins::smooth_parameters());
  const SmoothOptions& o = *run.options;
  const auto set_if = [&](const char* id, const std::optional<double>& value) {
    if (value) parameters.set_number(id, *value);
  };
  set_lists(parameters, o);
  parameters.set_choice("potential", o.potential.c_str());
  parameters.set_choice("engine", o.engine.c_str());
  parameters.set_number("relax", o.relax);
  parameters.set_number("threads", o.threads);
  parameters.set_number("tolerance", o.tolerance);
  set_if("click_distance", o.click_distance);
  set_if("max_deviation", o.max_deviation);
  set_if("heat_time", o.heat_time);
  set_if("budget", o.budget);
  set_if("budget_work", o.budget_work);
  set_field(parameters, "distance", run.distance);
  set_field(parameters, "slack_field", run.slack_field);
  return parameters;
}

void finish_reports(PlacedResult& result, const std::vector<std::vector<StageTimes>>& times,
                    const Prepared& run, const std::vector<std::string>& idle) {
  std::vector<std::string> warnings = run.warnings;
  warnings.insert(warnings.end(), idle.begin(), idle.end());
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    report.time_ms = median_times(times[c]);
    report.time_ms.open = times[c].front().open;  // the factors are made in the first run
    report.time_ms.load = run.load_ms;
    report.time_ms.total += run.load_ms;
    run.moved.add_to(report.warnings, warnings);
    lead_with(report, run.moved.decisive());
  }
  result.ridges = run.ridges;
  result.total = total_of(result.reports);
}

bool is_cancelled(const SmoothingReport& total) { return total.termination == Outcome::kCancelled; }

bool is_free(const Prepared& run) { return only_way_points(run.curves, run.points); }

/// The rest of a budget, seconds, after the files were read and the curves were set.
double left_of(double seconds, const Prepared& run, const Stopwatch& watch) {
  constexpr double kUsedUp = 1e-9;
  return std::max(kUsedUp, seconds - (run.opened_ms + watch.ms()) / 1000);
}

/// Smooths once, starting from the drawing.
SmoothingResult smooth_once(CurveSmoother& smoother, const Prepared& run,
                            const plugin::Parameters& parameters) {
  const Stopwatch watch;
  CurveOptions options = plugins::curve_options_of(parameters);
  options.pins = run.pins;
  options.corners = run.corners;
  options.way_points = run.points.way_points;
  options.painted = run.points.painted;
  if (!plugins::set_curves(smoother, run.curves, parameters, options, run.progress)) {
    SmoothingResult cancelled;
    cancelled.total.termination = Outcome::kCancelled;
    return cancelled;
  }
  SmoothingOptions own =
      plugins::smoothing_options_of(parameters, smoother.opened().surface(), smoother.drawn());
  if (own.budget.seconds) *own.budget.seconds = left_of(*own.budget.seconds, run, watch);
  return plugins::smooth_by(parameters, smoother, own, is_free(run), run.progress);
}

PlacedResult placed(const SurfaceMesh& mesh, SmoothingResult result, const Prepared& run) {
  PlacedResult smoothed;
  smoothed.reports = std::move(result.reports);
  for (const SurfaceCurve& curve : result.curves) {
    ReadyCurve made = ready(mesh, curve, smoothed.curves.size(), run.options->written, run.frame);
    if (made.spacing) smoothed.spacings.push_back(*made.spacing);
    smoothed.curves.push_back(std::move(made.curve));
  }
  return smoothed;
}

PlacedResult smooth_set(CurveSmoother& smoother, const Prepared& run) {
  PlacedResult result;
  std::vector<std::vector<StageTimes>> times(run.curves.size());
  std::vector<std::string> idle;
  try {
    const plugin::Parameters parameters = parameters_of(run);
    idle = plugins::idle_parameters(parameters, is_free(run));
    for (std::size_t k = 0; k < run.options->repeat; ++k) {
      SmoothingResult smoothed = smooth_once(smoother, run, parameters);
      if (is_cancelled(smoothed.total)) {
        result = {};
        result.total.termination = smoothed.total.termination;
        return result;
      }
      result = placed(smoother.opened().mesh(), std::move(smoothed), run);
      for (std::size_t c = 0; c < times.size(); ++c) times[c].push_back(result.reports[c].time_ms);
    }
  } catch (const plugin::Failure& failure) {
    throw Error(ErrorCode::kBadUsage, failure.what());
  }
  finish_reports(result, times, run, idle);
  return result;
}

/// Combines the results of independent curves in their order.
RunOutcome gathered(std::vector<PlacedResult> results, std::vector<CurveFailure> failures) {
  RunOutcome outcome;
  outcome.failures = std::move(failures);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (is_cancelled(results[i].total)) {
      outcome.result = {};
      outcome.result.total.termination = results[i].total.termination;
      return outcome;
    }
    if (results[i].curves.empty()) continue;
    outcome.numbers.push_back(i);
    outcome.result.curves.push_back(std::move(results[i].curves.front()));
    outcome.result.reports.push_back(std::move(results[i].reports.front()));
    for (const RidgeMoves& moves : results[i].ridges) outcome.result.ridges.push_back(moves);
    if (results[i].spacings.empty()) continue;
    outcome.result.spacings.push_back(results[i].spacings.front());
  }
  if (!outcome.numbers.empty()) outcome.result.total = total_of(outcome.result.reports);
  return outcome;
}

RunOutcome smooth_each(std::vector<std::unique_ptr<CurveSmoother>>& smoothers,
                       const MeshFromFile& mesh, const Prepared& run) {
  const std::size_t count = run.curves.size();
  std::vector<PlacedResult> results(count);
  std::vector<std::optional<CurveFailure>> failed(count);
  share_work(count, smoothers.size(), [&](std::size_t worker, std::size_t i) {
    if (!go_on(run.progress, "curves", static_cast<double>(i) / static_cast<double>(count))) {
      results[i].total.termination = Outcome::kCancelled;
      return;
    }
    try {
      if (!smoothers[worker]) smoothers[worker] = std::make_unique<CurveSmoother>(mesh.opened);
      const SmoothOptions options = options_of_curve(*run.options, i);
      Prepared one = alone(run, i);
      one.options = &options;
      results[i] = smooth_set(*smoothers[worker], one);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kBadUsage) throw;
      failed[i] = CurveFailure{i, current_failure()};
    }
  });
  std::vector<CurveFailure> failures;
  for (std::optional<CurveFailure>& failure : failed) {
    if (failure) failures.push_back(std::move(*failure));
  }
  return gathered(std::move(results), std::move(failures));
}

void add_resampling(std::vector<ReportEntry>& entries, std::size_t points, double spacing) {
  entries.push_back({"resampled_points", std::uint64_t{points}});
  entries.push_back({"resampled_spacing", spacing});
}

void add_entries(std::vector<ReportEntry>& entries, const std::vector<ReportEntry>& more) {
  entries.insert(entries.end(), more.begin(), more.end());
}

/// The report as JSON. Resampled curves have entries with their number of points and their spacing;
/// the totals have the number of all points and the largest spacing.
std::string report_json(const PlacedResult& result) {
  std::vector<ReportEntry> total = entries_of(result.total);
  add_entries(total, total_entries(result.ridges));
  std::vector<std::vector<ReportEntry>> curves;
  std::size_t points = 0;
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    curves.push_back(entries_of(result.reports[c]));
    if (!result.ridges.empty()) add_entries(curves.back(), entries_of(result.ridges[c]));
    if (result.spacings.empty()) continue;
    add_resampling(curves.back(), result.curves[c].positions.size(), result.spacings[c]);
    points += result.curves[c].positions.size();
  }
  if (!result.spacings.empty()) {
    add_resampling(total, points,
                   *std::max_element(result.spacings.begin(), result.spacings.end()));
  }
  return to_json(total, curves);
}

}  // namespace

bool RunOutcome::cancelled() const { return is_cancelled(result.total); }

MeshFromFile load_mesh(const std::string& path, const std::string& repair) {
  MeshFromFile mesh;
  const Stopwatch watch;
  ReadMesh read = read_and_repair(path, repair);
  mesh.map = std::move(read.map);
  mesh.changes = std::move(read.changes);
  mesh.load_ms = watch.ms();
  mesh.polygons = read.lists.polygon_count;
  mesh.frame = read.lists.frame();
  mesh.opened = OpenedMesh::open(std::move(read.lists));
  return mesh;
}

Workspace::Workspace(MeshFromFile mesh, std::size_t threads)
    : mesh_(std::move(mesh)), reader_(mesh_.mesh(), mesh_.map.get()), smoothers_(threads) {}

RunOutcome Workspace::smooth(const SmoothOptions& options, const Progress& progress) {
  RunOutcome outcome;
  Prepared run;
  try {
    run = prepare(mesh_, reader_, options, progress);
  } catch (const Cancelled&) {
    outcome.result.total.termination = Outcome::kCancelled;
    return outcome;
  }
  if (options.independent) {
    outcome = smooth_each(smoothers_, mesh_, run);
  } else {
    if (!smoothers_[0]) smoothers_[0] = std::make_unique<CurveSmoother>(mesh_.opened);
    outcome.result = smooth_set(*smoothers_[0], run);
    for (std::size_t i = 0; i < outcome.result.curves.size(); ++i) outcome.numbers.push_back(i);
  }
  outcome.moved = run.moved;
  outcome.frame = run.frame;
  for (PlacedCurve& curve : outcome.result.curves) {
    curve = in_file_numbers(mesh_.map.get(), std::move(curve));
  }
  return outcome;
}

void write_run(const SmoothOptions& options, const RunOutcome& outcome) {
  if (outcome.cancelled() || outcome.result.curves.empty()) return;
  OutputAttempts attempts;
  for (const std::string& output : options.outputs) {
    attempts.make(
        [&] { write_output(output, curve_bytes(output, outcome.result.curves, outcome.frame)); });
  }
  if (!options.report.empty()) {
    attempts.make([&] { write_output(options.report, report_json(outcome.result)); });
  }
  attempts.finish();
}

}  // namespace talweg::driver

#include "smooth_run.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <utility>

#include "shared_work.hpp"
#include "talweg/core/drawn_curves.hpp"
#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/max_deviation.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/core/stopwatch.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

/// One number per vertex.
std::vector<double> read_field(const std::string& path, std::size_t vertices) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorCode::kBadFile, path + ": cannot be opened.");
  std::vector<double> values;
  for (std::string word; in >> word;) {
    char* end = nullptr;
    values.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0') {
      throw Error(ErrorCode::kBadFile, path + ": value " + std::to_string(values.size()) + " (\"" +
                                           word.substr(0, 40) + "\") is not a number.");
    }
  }
  if (values.size() != vertices) {
    throw Error(ErrorCode::kBadFile, path + ": " + std::to_string(values.size()) +
                                         " values, but the mesh has " + std::to_string(vertices) +
                                         " vertices.");
  }
  return values;
}

/// The median of each stage over several runs that gave the same result.
StageTimes median_times(const std::vector<StageTimes>& runs) {
  StageTimes times;
  for (double StageTimes::*stage :
       {&StageTimes::load, &StageTimes::open, &StageTimes::solve, &StageTimes::straighten,
        &StageTimes::trace, &StageTimes::relax, &StageTimes::polish, &StageTimes::total}) {
    std::vector<double> values;
    values.reserve(runs.size());
    for (const StageTimes& run : runs) values.push_back(run.*stage);
    std::sort(values.begin(), values.end());
    times.*stage = values[values.size() / 2];
  }
  return times;
}

/// What is smoothed, and how: the options with all their files read.
struct Prepared {
  Drawing drawing;
  std::vector<double> distance;  ///< per vertex; empty unless given
  CurveOptions curve_options;
  SmoothingOptions smoothing;
  const SmoothOptions* options = nullptr;
  std::vector<std::string> warnings;
  double load_ms = 0;
};

Prepared prepare(const MeshFromFile& mesh, DrawingReader& reader, const SmoothOptions& options,
                 const Progress& progress) {
  const Surface& surface = mesh.opened->surface();
  Prepared run;
  run.options = &options;
  run.load_ms = mesh.load_ms;
  run.drawing = options.labels.empty() ? reader.read(options.curves)
                                       : drawing_of_labels(options.labels, surface);
  for (const std::size_t pin : options.pins) {
    run.drawing.pins.push_back(SurfacePoint::at_vertex(surface, VertexId{pin}));
  }
  run.curve_options = options.curve_options;
  run.smoothing = options.smoothing;
  run.smoothing.progress = progress;
  if (!options.distance.empty()) {
    run.distance = read_field(options.distance, surface.vertex_count());
  }
  if (!options.slack_field.empty()) {
    const auto field = read_field(options.slack_field, surface.vertex_count());
    for (const SurfaceCurve& curve : run.drawing.curves) {
      run.smoothing.slack_at.push_back(slack_along(surface, curve, field));
    }
  }
  run.warnings = reading_warnings(run.drawing.largest_snap_distance, mesh.polygons);
  return run;
}

/// The run of a single curve of it.
Prepared alone(const Prepared& run, std::size_t curve) {
  Prepared one;
  one.options = run.options;
  one.load_ms = run.load_ms;
  one.distance = run.distance;
  one.curve_options = run.curve_options;
  one.smoothing = run.smoothing;
  one.warnings = run.warnings;
  one.drawing.curves = {run.drawing.curves[curve]};
  const auto& points = one.drawing.curves[0].points;
  for (const SurfacePoint& pin : run.drawing.pins) {
    if (std::find(points.begin(), points.end(), pin) != points.end()) {
      one.drawing.pins.push_back(pin);
    }
  }
  if (!run.smoothing.slack_at.empty()) one.smoothing.slack_at = {run.smoothing.slack_at[curve]};
  return one;
}

bool set_curves(CurveSmoother& smoother, const Prepared& run) {
  CurveOptions options = run.curve_options;
  options.pins = run.drawing.pins;
  if (run.distance.empty()) {
    return smoother.set_curves(run.drawing.curves, options, run.smoothing.progress);
  }
  return smoother.set_curves(run.drawing.curves, run.distance, options);
}

SmoothingResult smooth_set(CurveSmoother& smoother, const Prepared& run) {
  const SmoothOptions& options = *run.options;
  SmoothingResult result;
  std::vector<std::vector<StageTimes>> times;
  for (std::size_t k = 0; k < options.repeat; ++k) {
    if (!set_curves(smoother, run)) {
      result.total.termination = to_string(Termination::kCancelled);
      return result;
    }
    result = options.max_deviation ? smooth_within(smoother, *options.max_deviation, run.smoothing)
                                   : smoother.smooth(run.smoothing);
    times.resize(result.reports.size());
    for (std::size_t c = 0; c < times.size(); ++c) times[c].push_back(result.reports[c].time_ms);
  }
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    report.time_ms = median_times(times[c]);
    report.time_ms.open = times[c].front().open;  // the factors are made in the first run
    report.time_ms.load = run.load_ms;
    report.time_ms.total += run.load_ms;
    report.warnings.insert(report.warnings.end(), run.warnings.begin(), run.warnings.end());
  }
  if (!result.reports.empty()) result.total = total_of(result.reports);
  return result;
}

bool is_cancelled(const SmoothingResult& result) {
  return result.total.termination == to_string(Termination::kCancelled);
}

/// What each curve came to, put together in their order.
RunOutcome gathered(std::vector<SmoothingResult> results, std::vector<CurveFailure> failures) {
  RunOutcome outcome;
  outcome.failures = std::move(failures);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (is_cancelled(results[i])) {
      outcome.result = {};
      outcome.result.total.termination = results[i].total.termination;
      return outcome;
    }
    if (results[i].curves.empty()) continue;
    outcome.numbers.push_back(i);
    outcome.result.curves.push_back(std::move(results[i].curves.front()));
    outcome.result.reports.push_back(std::move(results[i].reports.front()));
  }
  if (!outcome.numbers.empty()) outcome.result.total = total_of(outcome.result.reports);
  return outcome;
}

RunOutcome smooth_each(std::vector<std::unique_ptr<CurveSmoother>>& smoothers,
                       const MeshFromFile& mesh, const Prepared& run) {
  const std::size_t count = run.drawing.curves.size();
  check_pins(run.drawing.curves, run.drawing.pins);
  std::vector<SmoothingResult> results(count);
  std::vector<std::optional<CurveFailure>> failed(count);
  share_work(count, smoothers.size(), [&](std::size_t worker, std::size_t i) {
    if (!go_on(run.smoothing.progress, "curves",
               static_cast<double>(i) / static_cast<double>(count))) {
      results[i].total.termination = to_string(Termination::kCancelled);
      return;
    }
    try {
      if (!smoothers[worker]) smoothers[worker] = std::make_unique<CurveSmoother>(mesh.opened);
      results[i] = smooth_set(*smoothers[worker], alone(run, i));
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

}  // namespace

bool RunOutcome::cancelled() const { return is_cancelled(result); }

MeshFromFile load_mesh(const std::string& path) {
  MeshFromFile mesh;
  const Stopwatch watch;
  const MeshLists lists = read_mesh(path);
  mesh.load_ms = watch.ms();
  mesh.polygons = lists.polygon_count;
  mesh.opened = OpenedMesh::open(lists);
  return mesh;
}

Workspace::Workspace(MeshFromFile mesh, std::size_t threads)
    : mesh_(std::move(mesh)), reader_(mesh_.opened->mesh()), smoothers_(threads) {}

RunOutcome Workspace::smooth(const SmoothOptions& options, const Progress& progress) {
  const Prepared run = prepare(mesh_, reader_, options, progress);
  if (options.independent) return smooth_each(smoothers_, mesh_, run);
  if (!smoothers_[0]) smoothers_[0] = std::make_unique<CurveSmoother>(mesh_.opened);
  RunOutcome outcome;
  outcome.result = smooth_set(*smoothers_[0], run);
  for (std::size_t i = 0; i < outcome.result.curves.size(); ++i) outcome.numbers.push_back(i);
  return outcome;
}

void write_run(const SmoothOptions& options, const SurfaceMesh& mesh, const RunOutcome& outcome) {
  if (outcome.cancelled() || outcome.result.curves.empty()) return;
  for (const std::string& output : options.outputs) {
    write_curves(output, mesh, outcome.result.curves);
  }
  if (!options.report.empty()) {
    write_file(options.report, to_json(outcome.result.total, outcome.result.reports));
  }
}

}  // namespace talweg::driver

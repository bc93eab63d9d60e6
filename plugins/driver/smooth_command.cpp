// talweg smooth: the whole method on the curves of a file.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "drawing_file.hpp"
#include "progress_bar.hpp"
#include "report_table.hpp"
#include "talweg/core/curve_smoother.hpp"
#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/max_deviation.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/core/stopwatch.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

struct SmoothOptions {
  std::string mesh;
  std::string curve;
  std::vector<std::string> outputs;
  std::string report;
  std::string potential = "corridor";
  std::string engine = "auto";
  std::string distance;
  std::string slack_field;
  std::optional<double> max_deviation;
  std::optional<double> heat_time;
  std::vector<std::size_t> pins;
  std::size_t repeat = 1;
  CurveOptions curve_options;
  SmoothingOptions smoothing;
};

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

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
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
    times.*stage = median(values);
  }
  return times;
}

bool set_curves(CurveSmoother& smoother, const Drawing& drawing, const SmoothOptions& options,
                const Progress& progress) {
  CurveOptions curve_options = options.curve_options;
  curve_options.pins = drawing.pins;
  if (options.distance.empty()) return smoother.set_curves(drawing.curves, curve_options, progress);
  const std::size_t vertices = smoother.opened().surface().vertex_count();
  return smoother.set_curves(drawing.curves, read_field(options.distance, vertices), curve_options);
}

int finish(const SmoothOptions& options, const GlobalOptions& global, const SurfaceMesh& mesh,
           const SmoothingResult& result) {
  clear_progress_bar();
  if (result.total.termination == to_string(Termination::kCancelled)) {
    std::fprintf(stderr, "talweg: cancelled; nothing was written.\n");
    return kCancelled;
  }
  for (const std::string& output : options.outputs) write_curves(output, mesh, result.curves);
  if (!options.report.empty()) {
    write_file(options.report, to_json(result.total, result.reports));
  }
  const bool table = global.verbose || (options.outputs.empty() && options.report.empty());
  if (table && !global.quiet) std::fputs(table_of(result.total).c_str(), stdout);
  if (result.total.termination == to_string(Termination::kConverged)) return kDone;
  if (!global.quiet) {
    const bool far = result.total.termination == "deviation";
    std::fprintf(stderr, "talweg: %s; the best result was written all the same.\n",
                 far ? "no curve within --max-deviation was found"
                     : ("the result did not converge (" + result.total.termination + ")").c_str());
  }
  return kNotConverged;
}

void choose_method(SmoothOptions& options) {
  const bool corridor = options.potential == "corridor";
  const auto fail = [](const char* message) { throw Error(ErrorCode::kBadUsage, message); };
  if (corridor && options.engine == "full") fail("The corridor needs --engine local.");
  if (!corridor && options.engine == "local") fail("The paper's potential needs --engine full.");
  if (corridor && !options.distance.empty()) fail("--distance needs --potential paper.");
  if (corridor && options.heat_time) fail("--heat-time needs --potential paper.");
  if (!corridor && options.smoothing.slack) fail("--slack needs --potential corridor.");
  if (!corridor && !options.slack_field.empty()) fail("--slack-field needs --potential corridor.");
  if (!corridor && options.max_deviation) fail("--max-deviation needs --potential corridor.");
  if (options.heat_time) options.curve_options.heat_time = *options.heat_time;
  options.curve_options.method = corridor ? Method::kCorridor : Method::kPaper;
}

int run(SmoothOptions options, const GlobalOptions& global) {
  choose_method(options);
  options.curve_options.threads = global.threads;
  const Stopwatch load_watch;
  MeshLists lists = read_mesh(options.mesh);
  const double load_ms = load_watch.ms();
  const auto opened = OpenedMesh::open(lists);
  const std::size_t polygons = lists.polygon_count;
  lists = {};
  Drawing drawing = read_drawing(options.curve, opened->mesh());
  for (const std::size_t pin : options.pins) {
    drawing.pins.push_back(SurfacePoint::at_vertex(opened->surface(), VertexId{pin}));
  }

  if (!options.slack_field.empty()) {
    const auto field = read_field(options.slack_field, opened->surface().vertex_count());
    for (const SurfaceCurve& curve : drawing.curves) {
      options.smoothing.slack_at.push_back(slack_along(opened->surface(), curve, field));
    }
  }

  const Progress progress = progress_bar(global.quiet);
  options.smoothing.progress = progress;
  CurveSmoother smoother(opened);
  SmoothingResult result;
  std::vector<std::vector<StageTimes>> times;
  for (std::size_t k = 0; k < options.repeat; ++k) {
    if (!set_curves(smoother, drawing, options, progress)) {
      result.total.termination = to_string(Termination::kCancelled);
      break;
    }
    result = options.max_deviation
                 ? smooth_within(smoother, *options.max_deviation, options.smoothing)
                 : smoother.smooth(options.smoothing);
    times.resize(result.reports.size());
    for (std::size_t c = 0; c < times.size(); ++c) {
      times[c].push_back(result.reports[c].time_ms);
    }
  }
  for (std::size_t c = 0; c < result.reports.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    report.time_ms = median_times(times[c]);
    report.time_ms.open = times[c].front().open;  // the factors are made in the first run
    report.time_ms.load = load_ms;
    report.time_ms.total += load_ms;
    for (std::string& warning : reading_warnings(drawing.largest_snap_distance, polygons)) {
      report.warnings.push_back(std::move(warning));
    }
  }
  if (!result.reports.empty()) result.total = total_of(result.reports);
  return finish(options, global, opened->mesh(), result);
}

}  // namespace

Command add_smooth(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<SmoothOptions>();
  CLI::App* command =
      app.add_subcommand("smooth", "Smooth drawn curves while they stay close to the drawing");
  command->add_option("mesh", o->mesh, "Mesh: OBJ, OFF, PLY, STL or OM")->required();
  command
      ->add_option(
          "--curve", o->curve,
          "Drawn curves: .obj, .ply, .vtp, .vtk, .mrk.json, .txt (vertex numbers) or .json")
      ->required();
  command
      ->add_option("--tau", o->smoothing.tau, "0: straight lines; more keeps closer to the drawing")
      ->capture_default_str();
  command->add_option("-o,--output", o->outputs,
                      "Smoothed curves; the ending chooses the format; may be given several times");
  command->add_option("--report", o->report, "What was done and measured, as JSON");
  command
      ->add_option("--potential", o->potential,
                   "paper: equations 4 to 6; corridor: flat within the slack, exact distance")
      ->check(CLI::IsMember({"paper", "corridor"}))
      ->capture_default_str();
  command->add_option(
      "--slack", o->smoothing.slack,
      "How exact the drawing is, in mesh units (corridor; default: its mean segment)");
  command->add_option("--slack-field", o->slack_field,
                      "The slack near each mesh vertex, one number each, instead of --slack");
  command
      ->add_option(
          "--max-deviation", o->max_deviation,
          "The smoothest curve that deviates by no more, in mesh units, either way; chooses "
          "tau and slack")
      ->excludes("--tau");
  command
      ->add_option("--engine", o->engine,
                   "full: distance over the whole mesh (paper); local: near the drawing (corridor)")
      ->check(CLI::IsMember({"auto", "full", "local"}))
      ->capture_default_str();
  command
      ->add_option("--heat-time", o->heat_time,
                   "Smoothing of the paper's distance, in squared mean edge lengths")
      ->default_str("10");
  command->add_option("--distance", o->distance,
                      "Distance to the drawing, one number per vertex, used as it is");
  command->add_option("--pin", o->pins, "Vertices of the drawing that the result passes through")
      ->delimiter(',');
  command
      ->add_option("--relax", o->smoothing.relax_rounds,
                   "Rounds of relaxation along the supporting edges (the paper: 5)")
      ->capture_default_str();
  command->add_option("--repeat", o->repeat, "Run so often and report median times")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  return [o, &global] { return run(*o, global); };
}

}  // namespace talweg::driver

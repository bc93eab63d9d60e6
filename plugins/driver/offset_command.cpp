// talweg offset: curves at a distance along the surface from other curves.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "methods/curve_choices.hpp"
#include "output_file.hpp"
#include "plugin_options.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/offset/offset_curves.hpp"
#include "talweg/core/offset/offset_report.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "written_points.hpp"

namespace talweg::driver {
namespace {

struct OffsetCommandOptions {
  std::string mesh;
  std::vector<std::string> curves;
  std::vector<std::string> outputs;
  std::string report;
  std::string repair;
  std::string mesh_units;
  std::string ends = "auto";
  std::string side = "both";
  std::string caps = "round";
  OffsetOptions offset;
  WrittenPoints written;
};

OffsetOptions offset_options(const OffsetCommandOptions& o) {
  OffsetOptions options = o.offset;
  options.side = o.side == "left"    ? CurveSide::kLeft
                 : o.side == "right" ? CurveSide::kRight
                                     : CurveSide::kBoth;
  options.caps = o.caps == "none" ? OffsetCaps::kNone : OffsetCaps::kRound;
  options.validate();
  return options;
}

void check_files(const OffsetCommandOptions& o) {
  FilePlan files;
  files.reads("the mesh", o.mesh);
  files.reads("--curve", o.curves);
  files.writes("-o", o.outputs, check_curve_name);
  files.writes("--report", o.report);
  files.check();
}

std::string summary_of(const OffsetResult& result, double ms) {
  std::string text = fmt::format("{:<10}{:<8}{:>8}{:>8}{:>14}{:>14}\n", "distance", "side",
                                 "closed", "points", "length", "off by");
  for (const OffsetCurve& made : result.curves) {
    text += fmt::format("{:<10.6g}{:<8}{:>8}{:>8}{:>14.6g}{:>14.3g}\n", made.distance,
                        to_string(made.side), made.curve.closed ? "yes" : "no",
                        made.curve.points.size(), made.length, made.off_max);
  }
  return text + fmt::format("{} curves in {:.1f} ms\n", result.curves.size(), ms);
}

void write_curves(const OffsetCommandOptions& o, const SurfaceMesh& mesh, const ReadMesh& read,
                  const CoordinateFrame& frame, const OffsetResult& result) {
  std::vector<PlacedCurve> placed;
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    ReadyCurve made = ready(mesh, result.curves[c].curve, c, o.written, frame);
    placed.push_back(in_file_numbers(read.map.get(), std::move(made.curve)));
  }
  OutputAttempts attempts;
  for (const std::string& output : o.outputs) {
    attempts.make([&] { write_output(output, curve_bytes(output, placed, frame)); });
  }
  attempts.finish();
}

int run_offset(const OffsetCommandOptions& o, const GlobalOptions& global) {
  const OffsetOptions options = offset_options(o);
  check_unit(o.mesh_units);
  check_points(o.written);
  check_files(o);
  const ReadMesh read = read_and_repair(o.mesh, o.repair);
  const SurfaceMesh mesh = SurfaceMesh::open(read.lists);
  const CoordinateFrame frame = with_unit(read.lists.frame(), o.mesh_units);
  const Progress progress = progress_bar(global.quiet);
  DrawingReader reader(mesh, read.map.get());
  reader.set_ends(curve_ends(o.ends), {});
  const SnappedDrawing drawing = reader.read(o.curves, frame, progress);
  const Stopwatch watch;
  const OffsetResult result = offset_curves(mesh, drawing.curves, options, progress);
  const double ms = watch.ms();
  clear_progress_bar();
  check_any(result);
  lead_with_far_move(drawing, global.quiet);
  for (const std::string& warning : result.warnings) {
    if (!global.quiet) std::fprintf(stderr, "talweg: warning: %s\n", warning.c_str());
  }
  std::vector<std::string> reading = reading_warnings(drawing, read.lists.polygon_count);
  reading.insert(reading.end(), read.changes.begin(), read.changes.end());
  std::vector<std::string> warnings = result.warnings;
  drawing.add_to(warnings, reading);
  write_curves(o, mesh, read, frame, result);
  if (!o.report.empty()) {
    write_output(o.report, to_json(entries_of(mesh, result, warnings), curve_entries_of(result)));
  }
  if (global.quiet) return kDone;
  std::fputs(summary_of(result, ms).c_str(), text_stream());
  for (const std::string& sentence : reading) {
    std::fprintf(text_stream(), "%s\n", sentence.c_str());
  }
  return kDone;
}

void add_offset_options(CLI::App& command, const std::shared_ptr<OffsetCommandOptions>& o) {
  command
      .add_option("--distance", o->offset.distances,
                  "The distance along the surface, mesh units; or several, separated by commas")
      ->delimiter(',')
      ->required();
  command
      .add_option("--side", o->side,
                  "left or right: only this side, as seen along the curve from outside, without "
                  "caps; both: both sides")
      ->check(CLI::IsMember({"both", "left", "right"}))
      ->capture_default_str();
  command
      .add_option("--caps", o->caps,
                  "round: the offset runs around the ends of an open curve; none: the offset ends "
                  "there")
      ->check(CLI::IsMember({"round", "none"}))
      ->capture_default_str();
  command.add_option("--tolerance", o->offset.tolerance,
                     "The largest error of the distance between two points, mesh units (default: a "
                     "thousandth of the distance, and at most a fiftieth of the mean edge)");
  add_choice(command, plugins::ends_choice(), o->ends);
  command.add_flag_callback(
      "--closed", [o] { o->ends = "closed"; }, "The same as --ends closed");
}

}  // namespace

Command add_offset(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<OffsetCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "offset",
      "Curves at an exact distance along the surface from others: on both sides, or on one");
  command->add_option("mesh", o->mesh, mesh_help())->required();
  command->add_option("--curve", o->curves, "Curves to offset; may be given several times")
      ->required();
  add_offset_options(*command, o);
  command
      ->add_option("-o,--output", o->outputs,
                   "Curves, one for each component; the ending chooses the format; may be given "
                   "several times")
      ->required();
  command->add_option("--report", o->report, "Side, length and error of each curve, as JSON");
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  add_point_options(*command, o->written);
  return [o, &global] { return run_offset(*o, global); };
}

}  // namespace talweg::driver

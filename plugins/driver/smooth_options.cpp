#include "smooth_options.hpp"

#include "repaired_mesh.hpp"
#include "talweg/core/formats/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

void add_inputs(CLI::App& app, SmoothOptions& o) {
  CLI::Option* curve = app.add_option(
      "--curve", o.curves,
      "Drawn curves: .obj, .ply, .vtp, .vtk, .mrk.json, .txt (vertex numbers) or .json; may be "
      "given several times");
  app.add_option("--labels", o.labels,
                 "Instead of curves: the borders between these labels, one whole number per face")
      ->excludes(curve);
  app.add_flag("--independent", o.independent,
               "Smooth each curve by itself; by default all are one set, in which none crosses "
               "another");
  app.add_option("--pin", o.pins, "Vertices of the drawing that the result passes through")
      ->delimiter(',');
  add_repair_option(app, o.repair);
  add_unit_option(app, o.mesh_units);
}

void add_outputs(CLI::App& app, SmoothOptions& o) {
  app.add_option("-o,--output", o.outputs,
                 "Smoothed curves; the ending chooses the format; may be given several times");
  app.add_option("--report", o.report, "What was done and measured, as JSON");
}

void add_closeness(CLI::App& app, SmoothOptions& o) {
  app.add_option("--tau", o.tau, "0: straight lines; more keeps closer to the drawing")
      ->capture_default_str();
  app.add_option(
      "--slack", o.slack,
      "How exact the drawing is, in mesh units (corridor; default: 0.7 of its median segment, "
      "less where it turns little, at most 1/24 of its length)");
  app.add_option("--slack-field", o.slack_field,
                 "The slack near each mesh vertex, one number each, instead of --slack");
  app.add_option("--max-deviation", o.max_deviation,
                 "The smoothest curve that deviates by no more, in mesh units, either way; chooses "
                 "tau and slack")
      ->excludes("--tau");
}

void add_method(CLI::App& app, SmoothOptions& o) {
  app.add_option("--potential", o.potential,
                 "paper: equations 4 to 6; corridor: flat within the slack, exact distance")
      ->check(CLI::IsMember({"paper", "corridor"}))
      ->capture_default_str();
  app.add_option("--engine", o.engine,
                 "full: distance over the whole mesh (paper); local: near the drawing (corridor)")
      ->check(CLI::IsMember({"auto", "full", "local"}))
      ->capture_default_str();
  app.add_option("--heat-time", o.heat_time,
                 "Smoothing of the paper's distance, in squared mean edge lengths")
      ->default_str("10");
  app.add_option("--distance", o.distance,
                 "Distance to the drawing, one number per vertex, used as it is");
  app.add_option("--relax", o.relax,
                 "Rounds of relaxation along the supporting edges (the paper: 5)")
      ->capture_default_str();
  app.add_option("--repeat", o.repeat, "Run so often and report median times")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
}

}  // namespace

void add_smooth_options(CLI::App& app, SmoothOptions& options) {
  add_inputs(app, options);
  add_closeness(app, options);
  add_outputs(app, options);
  add_method(app, options);
}

void plan_files(const SmoothOptions& options, FilePlan& files) {
  files.reads("the mesh", options.mesh);
  files.reads("--curve", options.curves);
  files.reads("--labels", options.labels);
  files.reads("--distance", options.distance);
  files.reads("--slack-field", options.slack_field);
  files.writes("-o", options.outputs, check_curve_name);
  files.writes("--report", options.report);
}

void check_method(const SmoothOptions& options) {
  check_repair(options.repair);
  LengthUnit::named(options.mesh_units);
  const bool corridor = options.potential == "corridor";
  const auto fail = [](const char* message) { throw Error(ErrorCode::kBadUsage, message); };
  if (corridor && options.engine == "full") fail("The corridor needs --engine local.");
  if (!corridor && options.engine == "local") fail("The paper's potential needs --engine full.");
  if (corridor && !options.distance.empty()) fail("--distance needs --potential paper.");
  if (corridor && options.heat_time) fail("--heat-time needs --potential paper.");
  if (!corridor && options.slack) fail("--slack needs --potential corridor.");
  if (!corridor && !options.slack_field.empty()) fail("--slack-field needs --potential corridor.");
  if (!corridor && options.max_deviation) fail("--max-deviation needs --potential corridor.");
}

}  // namespace talweg::driver

// talweg compare: all methods on one drawing, measured in the same way.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "compare/comparison.hpp"
#include "compare/picture.hpp"
#include "compare/plot.hpp"
#include "compare/table.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {
namespace {

struct CompareCommandOptions {
  std::string mesh;
  std::vector<std::string> curves;
  std::string methods;
  bool sweep = false;
  std::string picture, plot, report, table, results;
  std::string repair;
  std::string mesh_units;
};

/// Writes the curves of each method with a result as PREFIX-METHOD.json. A sweep numbers the files.
void write_results(const std::string& prefix, const Comparison& c) {
  std::vector<std::size_t> count(c.methods.size(), 0);
  for (const ComparedRun& run : c.runs) {
    const std::size_t number = count[run.method]++;
    if (!run.refusal.empty()) continue;
    const std::string name = prefix + "-" + c.methods[run.method].name;
    const std::string path =
        run.value ? name + "-" + std::to_string(number) + ".json" : name + ".json";
    write_output(path, curve_bytes(path, run.curves));
  }
}

void write(const CompareCommandOptions& o, const Comparison& comparison, const MeshLists& mesh) {
  const std::string title = std::filesystem::path(o.mesh).stem().string();
  OutputAttempts attempts;
  const auto write_to = [&](const std::string& path, const auto& bytes) {
    if (!path.empty()) attempts.make([&] { write_output(path, bytes()); });
  };
  write_to(o.report, [&] { return comparison_json(comparison); });
  write_to(o.table, [&] { return comparison_csv(comparison); });
  write_to(o.plot, [&] { return comparison_plot(comparison, title); });
  if (!o.results.empty()) attempts.make([&] { write_results(o.results, comparison); });
  write_to(o.picture, [&] { return comparison_picture(comparison, mesh); });
  attempts.finish();
}

void check_files(const CompareCommandOptions& o, const std::vector<Method>& methods) {
  FilePlan files;
  files.reads("the mesh", o.mesh);
  files.reads("--curve", o.curves);
  files.writes("-o", o.picture);
  files.writes("--plot", o.plot);
  files.writes("--report", o.report);
  files.writes("--table", o.table);
  if (is_standard_output(o.results)) {
    throw Error(ErrorCode::kBadUsage,
                "--results writes several files, but the standard output is a single file.");
  }
  for (const Method& method : methods) {
    if (o.results.empty()) break;
    const std::string name = o.results + "-" + method.name;
    files.writes("--results", name + ".json");
    if (o.sweep) files.writes_numbered("--results", name + "-", ".json");
  }
  files.check();
}

int run_compare(const CompareCommandOptions& o, const GlobalOptions& global) {
  CompareOptions options{methods_of(o.methods), o.sweep, progress_bar(global.quiet)};
  if (!o.plot.empty() && !o.sweep) {
    throw Error(ErrorCode::kBadUsage, "--plot needs --sweep: it shows a line for each method.");
  }
  check_unit(o.mesh_units);
  check_files(o, options.methods);
  const ReadMesh read = read_and_repair(o.mesh, o.repair);
  const SurfaceMesh mesh = SurfaceMesh::open(read.lists);
  const CoordinateFrame frame = with_unit(read.lists.frame(), o.mesh_units);
  const SnappedDrawing drawing = DrawingReader(mesh, read.map.get()).read(o.curves, frame);
  lead_with_far_move(drawing, global.quiet);
  Comparison comparison;
  try {
    comparison = compare_methods(read, drawing, mesh, options);
  } catch (const host::Error&) {
    clear_progress_bar();
    std::fprintf(stderr, "talweg: cancelled; nothing was written.\n");
    return kCancelled;
  }
  clear_progress_bar();
  comparison.mesh = o.mesh;
  comparison.curve = o.curves.front();
  write(o, comparison, read.lists);
  if (global.quiet) return kDone;
  std::string text = comparison_table(comparison) + comparison_remarks(comparison);
  for (const std::string& change : read.changes) text += change + "\n";
  for (const std::string& warning : reading_warnings(drawing, read.lists.polygon_count)) {
    text += warning + "\n";
  }
  std::fputs(text.c_str(), text_stream());
  return kDone;
}

}  // namespace

Command add_compare(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<CompareCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Smooth one drawing by all methods, and measure all results in the same way");
  command->add_option("mesh", o->mesh, mesh_help())->required();
  command
      ->add_option("--curve", o->curves,
                   "Curves: .obj, .ply, .vtp, .vtk, .mrk.json, .border, .fcsv, .txt (vertex "
                   "numbers) or .json; may "
                   "be given several times")
      ->required();
  std::string names;
  for (const Method& method : known_methods()) names += (names.empty() ? "" : ", ") + method.name;
  command->add_option("--methods", o->methods,
                      "The methods to run, separated by commas: " + names +
                          " (default: all of these), or any plugin by its id");
  command->add_flag("--sweep", o->sweep,
                    "Run each method with many values of its parameter, from close to smooth");
  command->add_option("-o,--output", o->picture, "A picture of all curves, .png");
  command->add_option("--plot", o->plot,
                      "With --sweep: curvature against deviation, a line per method, .svg");
  command->add_option("--report", o->report, "All measures of all results, as JSON");
  command->add_option("--table", o->table, "All measures as .csv, a line per run");
  command->add_option("--results", o->results,
                      "The resulting curves: files RESULTS-METHOD.json, numbered with --sweep");
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  return [o, &global] { return run_compare(*o, global); };
}

}  // namespace talweg::driver

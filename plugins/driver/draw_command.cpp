// talweg draw: a curve through given vertices, straight or along mesh edges.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/drawing/draw.hpp"
#include "talweg/core/drawing/length_unit.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

struct Options {
  std::string mesh;
  std::vector<std::uint32_t> through;
  bool closed = false;
  bool straight = false, edges = false;
  std::vector<std::string> outputs;
  std::string repair;
  std::string mesh_units = "mm";
  std::string points = "exact";
};

/// The way-points, in the numbers of the mesh.
std::vector<VertexId> through_on(const SurfaceMesh& mesh, const RepairMap* map,
                                 const Options& options) {
  CurveInput input;
  input.closed = options.closed;
  std::vector<VertexId> ids;
  for (const std::uint32_t v : options.through) ids.emplace_back(v);
  input.points = std::move(ids);
  if (map != nullptr) input = map->to_repaired(input, mesh.surface());
  return std::get<std::vector<VertexId>>(input.points);
}

PlacedCurve drawn(const SurfaceMesh& mesh, const RepairMap* map, const Options& options,
                  const Progress& progress) {
  std::vector<SurfacePoint> clicks;
  for (const VertexId v : through_on(mesh, map, options)) {
    clicks.push_back(SurfacePoint::at_vertex(mesh.surface(), v));
  }
  DrawOptions own;
  own.closed = options.closed;
  if (options.points == "rough") own.tolerance.reset();
  const bool of_vertices =
      std::any_of(options.outputs.begin(), options.outputs.end(),
                  [](const std::string& output) { return output.ends_with(".txt"); });
  if (options.straight || options.edges || of_vertices) own.straight = options.straight;
  const Drawing drawing = draw(mesh.surface(), clicks, own, progress);
  PlacedCurve placed = place(mesh, drawing.curve);
  if (options.points == "exact") placed.exact = marks_through(drawing.curve, clicks);
  return placed;
}

/// Says of which files the points are a stroke, because the format has no way-points.
void tell_strokes(const Options& options) {
  std::string names;
  for (const std::string& output : options.outputs) {
    if (!holds_way_points(output)) names += (names.empty() ? "" : ", ") + output;
  }
  if (names.empty() || options.points != "exact") return;
  std::fprintf(text_stream(), "%s: the path, a stroke; .json, .vtp and .vtk hold way-points.\n",
               names.c_str());
}

int run(const Options& options, const GlobalOptions& global) {
  const LengthUnit unit = LengthUnit::named(options.mesh_units);
  FilePlan files;
  files.reads("the mesh", options.mesh);
  files.writes("-o", options.outputs, check_curve_name);
  files.check();
  const ReadMesh read = read_and_repair(options.mesh, options.repair);
  const SurfaceMesh mesh = SurfaceMesh::open(read.lists);
  std::vector<PlacedCurve> curves;
  try {
    PlacedCurve curve = drawn(mesh, read.map.get(), options, progress_bar(global.quiet));
    curves.push_back(in_file_numbers(read.map.get(), std::move(curve)));
  } catch (const Error& error) {
    rethrow_with_weld_hint(error, read.lists);
  }
  clear_progress_bar();
  for (const std::string& output : options.outputs) {
    write_output(output, curve_bytes(output, curves, unit));
  }
  if (!global.quiet) tell_strokes(options);
  for (const std::string& change : read.changes) {
    if (!global.quiet) std::fprintf(text_stream(), "%s\n", change.c_str());
  }
  return kDone;
}

}  // namespace

Command add_draw(CLI::App& app, const GlobalOptions& global) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "draw", "Draw a curve through mesh vertices: straight over the faces, or along edges");
  command->add_option("mesh", options->mesh, mesh_help())->required();
  command
      ->add_option("--through", options->through,
                   "Vertex numbers from 0, separated by commas, in the order of drawing")
      ->delimiter(',')
      ->required();
  command->add_flag("--closed", options->closed, "Go back to the first vertex");
  CLI::Option* straight = command->add_flag(
      "--straight", options->straight,
      "Straight over the faces, where legs may cross; the default between way-points");
  command
      ->add_flag(
          "--edges", options->edges,
          "Along edges of the mesh, never through itself; the default of a stroke, and where a "
          "file is written that holds vertices only")
      ->excludes(straight);
  command
      ->add_option("--points", options->points,
                   "exact: the vertices are way-points, which a result passes; rough: the whole "
                   "path is a stroke, as of a trembling hand")
      ->check(CLI::IsMember({"exact", "rough"}))
      ->capture_default_str();
  command
      ->add_option("-o,--output", options->outputs,
                   "Curve: .obj, .ply, .vtp, .vtk, .mrk.json, .txt (vertex numbers) or .json")
      ->required();
  add_repair_option(*command, options->repair);
  add_unit_option(*command, options->mesh_units);
  return [options, &global] { return run(*options, global); };
}

}  // namespace talweg::driver

// talweg draw: a jagged curve along mesh edges, or a straight one, through given vertices.
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "plugin_host.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/version.hpp"
#include "weld_hint.hpp"

namespace talweg::driver {
namespace {

struct DrawOptions {
  std::string mesh;
  std::vector<std::uint32_t> through;
  bool closed = false;
  bool straight = false;
  std::vector<std::string> outputs;
  std::string repair;
  std::string mesh_units = "mm";
};

/// The vertices to draw through, in the numbers of the mesh.
std::vector<std::uint32_t> through_on(const ReadMesh& mesh, const DrawOptions& options) {
  if (mesh.map == nullptr) return options.through;
  CurveInput input;
  input.closed = options.closed;
  std::vector<VertexId> ids;
  for (const std::uint32_t v : options.through) ids.push_back(VertexId{v});
  input.points = std::move(ids);
  const Surface surface = Surface::from_triangles(mesh.lists.points.size(), mesh.lists.triangles);
  return host_curve(mesh.map->to_repaired(input, surface)).vertices;
}

host::Results drawn(const ReadMesh& mesh, const DrawOptions& options, bool quiet) {
  const host::Services services("talweg", version(), progress_bar(quiet));
  return translated([&] {
    host::Instance draw(plugin_named("talweg.draw"), services);
    set_mesh(draw, mesh.lists.points, mesh.lists.triangles);
    host::Curve through;
    through.closed = options.closed;
    through.vertices = through_on(mesh, options);
    draw.set_curves({through});
    draw.set("straight", options.straight ? 1.0 : 0.0);
    return draw.run();
  });
}

int run(const DrawOptions& options, const GlobalOptions& global) {
  const LengthUnit unit = LengthUnit::named(options.mesh_units);
  FilePlan files;
  files.reads("the mesh", options.mesh);
  files.writes("-o", options.outputs, check_curve_name);
  files.check();
  const ReadMesh mesh = read_and_repair(options.mesh, options.repair);
  host::Results results;
  try {
    results = drawn(mesh, options, global.quiet);
  } catch (const Error& error) {
    rethrow_with_weld_hint(error, mesh.lists);
  }
  clear_progress_bar();
  std::vector<PlacedCurve> curves;
  for (const host::Curve& curve : results.curves) {
    curves.push_back(in_file_numbers(mesh.map.get(), placed_curve(curve)));
  }
  for (const std::string& output : options.outputs) {
    write_output(output, curve_bytes(output, curves, unit));
  }
  for (const std::string& change : mesh.changes) {
    if (!global.quiet) std::fprintf(text_stream(), "%s\n", change.c_str());
  }
  return kDone;
}

}  // namespace

Command add_draw(CLI::App& app, const GlobalOptions& global) {
  auto options = std::make_shared<DrawOptions>();
  CLI::App* command = app.add_subcommand(
      "draw", "Draw a curve through mesh vertices: shortest edge paths, never through itself");
  command->add_option("mesh", options->mesh, "Mesh: OBJ, OFF, PLY, STL or OM")->required();
  command
      ->add_option("--through", options->through,
                   "Vertex numbers from 0, separated by commas, in the order of drawing")
      ->delimiter(',')
      ->required();
  command->add_flag("--closed", options->closed, "Go back to the first vertex");
  command->add_flag("--straight", options->straight,
                    "Straight over the faces instead of along edges");
  command
      ->add_option("-o,--output", options->outputs,
                   "Curve: .obj, .ply, .vtp, .vtk, .mrk.json, .txt (vertex numbers) or .json")
      ->required();
  add_repair_option(*command, options->repair);
  add_unit_option(*command, options->mesh_units);
  return [options, &global] { return run(*options, global); };
}

}  // namespace talweg::driver

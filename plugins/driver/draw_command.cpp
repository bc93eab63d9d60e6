// talweg draw: a jagged curve along mesh edges, or a straight one, through given vertices.
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "plugin_host.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

struct DrawOptions {
  std::string mesh;
  std::vector<std::uint32_t> through;
  bool closed = false;
  bool straight = false;
  std::vector<std::string> outputs;
  std::string repair;
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

int run(const DrawOptions& options, const GlobalOptions& global) {
  const ReadMesh mesh = read_and_repair(options.mesh, options.repair);
  const host::Services services("talweg", version(), progress_bar(global.quiet));
  const host::Results results = translated([&] {
    host::Instance draw(plugin_named("talweg.draw"), services);
    set_mesh(draw, mesh.lists.points, mesh.lists.triangles);
    host::Curve through;
    through.closed = options.closed;
    through.vertices = through_on(mesh, options);
    draw.set_curves({through});
    draw.set("straight", options.straight ? 1.0 : 0.0);
    return draw.run();
  });
  clear_progress_bar();
  std::vector<PlacedCurve> curves;
  for (const host::Curve& curve : results.curves) {
    curves.push_back(in_file_numbers(mesh.map.get(), placed_curve(curve)));
  }
  for (const std::string& output : options.outputs) write_curves(output, curves);
  for (const std::string& change : mesh.changes) {
    if (!global.quiet) std::fprintf(stdout, "%s\n", change.c_str());
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
  return [options, &global] { return run(*options, global); };
}

}  // namespace talweg::driver

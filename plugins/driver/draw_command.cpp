// talweg draw: a jagged curve along mesh edges, or a straight one, through given vertices.
#include <string>
#include <vector>

#include "commands.hpp"
#include "plugin_host.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

struct DrawOptions {
  std::string mesh;
  std::vector<std::uint32_t> through;
  bool closed = false;
  bool straight = false;
  std::vector<std::string> outputs;
};

int run(const DrawOptions& options) {
  const host::Services services("talweg", version());
  const host::Results results = translated([&] {
    host::Instance draw(plugin_named("talweg.draw"), services);
    const MeshLists lists = read_mesh(options.mesh);
    set_mesh(draw, lists.points, lists.triangles);
    host::Curve through;
    through.closed = options.closed;
    through.vertices = options.through;
    draw.set_curves({through});
    draw.set("straight", options.straight ? 1.0 : 0.0);
    return draw.run();
  });
  std::vector<PlacedCurve> curves;
  for (const host::Curve& curve : results.curves) curves.push_back(placed_curve(curve));
  for (const std::string& output : options.outputs) write_curves(output, curves);
  return kDone;
}

}  // namespace

Command add_draw(CLI::App& app, const GlobalOptions& /*global*/) {
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
  return [options] { return run(*options); };
}

}  // namespace talweg::driver

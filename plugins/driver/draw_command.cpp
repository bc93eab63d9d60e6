// talweg draw: a jagged curve along mesh edges, or a straight one, through given vertices.
#include <string>
#include <vector>

#include "commands.hpp"
#include "talweg/core/drawing.hpp"
#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/core/straight_lines.hpp"
#include "talweg/core/surface_mesh.hpp"

namespace talweg::driver {
namespace {

struct DrawOptions {
  std::string mesh;
  std::vector<std::size_t> through;
  bool closed = false;
  bool straight = false;
  std::vector<std::string> outputs;
};

SurfaceCurve draw(const Surface& surface, const DrawOptions& options) {
  std::vector<VertexId> through;
  std::vector<SurfacePoint> points;
  for (const std::size_t v : options.through) {
    points.push_back(SurfacePoint::at_vertex(surface, VertexId{v}));
    through.emplace_back(v);
  }
  if (options.straight) return StraightLines(surface).join(points, options.closed);
  SurfaceCurve curve{options.closed, {}};
  for (const VertexId v : draw_edge_path(surface, through, options.closed)) {
    curve.points.push_back(SurfacePoint::at_vertex(surface, v));
  }
  return curve;
}

int run(const DrawOptions& options) {
  const SurfaceMesh mesh = SurfaceMesh::open(read_mesh(options.mesh));
  const std::vector<SurfaceCurve> curves = {draw(mesh.surface(), options)};
  for (const std::string& output : options.outputs) write_curves(output, mesh, curves);
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

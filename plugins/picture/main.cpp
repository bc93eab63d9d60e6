// talweg-picture: curves on a shaded mesh, as a PNG file.
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture/arguments.hpp"
#include "picture/render.hpp"
#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::picture {
namespace {

const Point& vertex_position(const MeshLists& mesh, std::size_t v) {
  if (v >= mesh.points.size()) {
    throw Error(ErrorCode::kBadCurve, "a curve passes through vertex " + std::to_string(v) +
                                          ", but the mesh has only " +
                                          std::to_string(mesh.points.size()));
  }
  return mesh.points[v];
}

Point position(const MeshLists& mesh, VertexId v) { return vertex_position(mesh, v.index()); }

Point position(const MeshLists& mesh, const FaceCoordinates& point) {
  if (point.face.index() >= mesh.triangles.size()) {
    throw Error(ErrorCode::kBadCurve,
                "a curve passes through face " + std::to_string(point.face.index()) +
                    ", but the mesh has only " + std::to_string(mesh.triangles.size()));
  }
  Point sum = Point::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    sum += point.barycentric[k] * vertex_position(mesh, mesh.triangles[point.face.index()][k]);
  }
  return sum;
}

Point position(const MeshLists& /*mesh*/, const Point& point) { return point; }

std::vector<Point> positions(const MeshLists& mesh, const CurveInput& curve) {
  std::vector<Point> result;
  const auto append = [&](const auto& points) {
    for (const auto& p : points) result.push_back(position(mesh, p));
  };
  std::visit(append, curve.points);
  return result;
}

struct Arguments {
  std::string mesh, output, fit = "auto", view, up;
  std::vector<std::string> curves, panels;
  double zoom = 1;
  RenderOptions options;
  bool no_edges = false;
};

// A file may hold several curves; panels count files.
Scene scene_of(const Arguments& arguments) {
  Scene scene;
  scene.mesh = read_mesh(arguments.mesh);
  std::vector<std::vector<std::size_t>> curves_of_file;
  for (const std::string& text : arguments.curves) {
    const CurveArgument argument = curve_argument(text);
    curves_of_file.emplace_back();
    for (const CurveInput& curve : read_curves(argument.file)) {
      curves_of_file.back().push_back(scene.curves.size());
      scene.curves.push_back(
          {positions(scene.mesh, curve), curve.closed, argument.color, argument.width});
    }
  }
  Panel single;
  single.fit = fit_argument(arguments.fit);
  single.zoom = arguments.zoom;
  if (!arguments.view.empty()) single.view = direction_argument(arguments.view);
  if (!arguments.up.empty()) scene.up = direction_argument(arguments.up);
  for (const std::string& text : arguments.panels) {
    Panel panel = panel_argument(text);
    const std::vector<std::size_t> files = std::exchange(panel.curves, {});
    for (const std::size_t file : files) {
      if (file >= curves_of_file.size()) {
        throw Error(ErrorCode::kBadUsage, "\"" + text + "\" names curve " +
                                              std::to_string(file + 1) + ", but only " +
                                              std::to_string(curves_of_file.size()) + " are given");
      }
      panel.curves.insert(panel.curves.end(), curves_of_file[file].begin(),
                          curves_of_file[file].end());
    }
    if (!panel.view) panel.view = single.view;
    scene.panels.push_back(std::move(panel));
  }
  if (scene.panels.empty()) scene.panels.push_back(single);
  return scene;
}

int run(int argc, char** argv) {
  CLI::App app("Draws curves on a shaded mesh and writes a PNG file; needs no display.",
               "talweg-picture");
  Arguments a;
  app.add_option("MESH", a.mesh, "Mesh file: OBJ, OFF, PLY, STL or OM")->required();
  app.add_option("-o,--output", a.output, "The PNG file to be written")->required();
  app.add_option("--curve", a.curves, "FILE[:rrggbb[:width in pixels]]; may be repeated");
  app.add_option(
      "--panel", a.panels,
      "CAPTION[|curves=1,2][|fit=FIT][|zoom=Z][|view=x,y,z]; several stand side by side");
  app.add_option("--fit", a.fit, "What a picture without panels shows: auto, curve, mesh, detail");
  app.add_option("--zoom", a.zoom, "Enlarges what --fit chose");
  app.add_option("--view", a.view, "x,y,z: direction from the mesh to the viewer");
  app.add_option("--up", a.up, "x,y,z: what points up in the picture");
  app.add_option("--width", a.options.panel_width, "Width of a panel in pixels");
  app.add_option("--height", a.options.panel_height, "Height of a panel in pixels");
  app.add_option("--samples", a.options.supersampling, "Samples per pixel in x and in y");
  app.add_flag("--no-edges", a.no_edges, "No lines along the mesh's edges");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::kBadUsage, error.what());
  }
  a.options.mesh_edges = !a.no_edges;
  a.options.validate();
  write_png(a.output, render(scene_of(a), a.options));
  return 0;
}

}  // namespace
}  // namespace talweg::picture

int main(int argc, char** argv) {
  try {
    return talweg::picture::run(argc, argv);
  } catch (const talweg::Error& error) {
    std::fprintf(stderr, "talweg-picture: %s\n", error.what());
    return error.code() == talweg::ErrorCode::kBadUsage ? 1 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-picture: %s\n", error.what());
    return 5;
  }
}

// talweg-picture: curves on a shaded mesh, as a PNG file.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/picture/arguments.hpp"
#include "tools/picture/contact_sheet.hpp"
#include "tools/picture/curvature_plot.hpp"
#include "tools/picture/curve_turning.hpp"
#include "tools/picture/face_colors.hpp"
#include "tools/picture/render.hpp"

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

Point position(const MeshLists& mesh, const CornerCoordinates& point) {
  Point sum = Point::Zero();
  double weights = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += point.weights[k] * vertex_position(mesh, point.corners[k].index());
    weights += point.weights[k];
  }
  return sum / weights;
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
  std::vector<std::string> curves, panels, curvature;
  double zoom = 1;
  RenderOptions options;
  bool no_edges = false;
};

/// Adds the curves of the files, and returns the indices of each file's curves.
std::vector<std::vector<std::size_t>> add_curves(const Arguments& arguments, Scene& scene) {
  std::vector<std::vector<std::size_t>> of_file;
  for (const std::string& text : arguments.curves) {
    const CurveArgument argument = curve_argument(text);
    of_file.emplace_back();
    for (const CurveInput& curve : read_curves(argument.file)) {
      of_file.back().push_back(scene.curves.size());
      scene.curves.push_back(
          {positions(scene.mesh, curve), curve.closed, argument.color, argument.width});
    }
  }
  return of_file;
}

/// Translates a panel's file numbers to the scene's curve indices.
void count_curves(Panel& panel, const std::string& text,
                  const std::vector<std::vector<std::size_t>>& of_file) {
  const std::vector<std::size_t> files = std::exchange(panel.curves, {});
  for (const std::size_t file : files) {
    if (file >= of_file.size()) {
      throw Error(ErrorCode::kBadUsage, "\"" + text + "\" names curve " + std::to_string(file + 1) +
                                            ", but only " + std::to_string(of_file.size()) +
                                            " are given");
    }
    panel.curves.insert(panel.curves.end(), of_file[file].begin(), of_file[file].end());
  }
}

/// The scene of a panel with its own mesh or colours.
Scene own_scene(const Scene& scene, const PanelArgument& panel) {
  Scene own = scene;
  own.panels = {panel};
  if (!panel.mesh.empty()) own.mesh = read_mesh(panel.mesh);
  if (panel.labels == "pieces") {
    own.face_colors = label_colors(pieces_of(own.mesh));
  } else if (!panel.labels.empty()) {
    own.face_colors = label_colors(read_label_file(panel.labels));
  }
  if (panel.move) move_apart(own.mesh, *panel.move);
  if (panel.no_curves) own.curves.clear();
  return own;
}

Image panels_of(const Arguments& arguments, Scene& scene) {
  const std::vector<std::vector<std::size_t>> curves_of_file = add_curves(arguments, scene);
  Panel single;
  single.fit = fit_argument(arguments.fit);
  single.zoom = arguments.zoom;
  if (!arguments.view.empty()) single.view = direction_argument(arguments.view);
  if (!arguments.up.empty()) scene.up = direction_argument(arguments.up);
  std::vector<PanelArgument> panels;
  bool apart = false;
  for (const std::string& text : arguments.panels) {
    PanelArgument& panel = panels.emplace_back(panel_argument(text));
    count_curves(panel, text, curves_of_file);
    if (!panel.view) panel.view = single.view;
    if (panel.at) panel.detail = detail_at(scene, *panel.at);
    apart |= !panel.mesh.empty() || !panel.labels.empty() || panel.move || panel.no_curves;
  }
  if (apart) {
    std::vector<Image> images;
    images.reserve(panels.size());
    for (const PanelArgument& panel : panels) {
      images.push_back(render(own_scene(scene, panel), arguments.options));
    }
    return contact_sheet(images, images.size());
  }
  for (const PanelArgument& panel : panels) scene.panels.push_back(panel);
  if (scene.panels.empty()) scene.panels.push_back(single);
  return render(scene, arguments.options);
}

/// The plot of the curves with a name; of a file with several curves, of the first.
Image plot_of(const Arguments& arguments, const Scene& scene, std::size_t width) {
  std::vector<CurveInput> inputs;
  CurvaturePlot plot;
  for (std::size_t k = 0; k < arguments.curves.size(); ++k) {
    const CurveArgument argument = curve_argument(arguments.curves[k]);
    if (k >= arguments.curvature.size() || arguments.curvature[k] == "-") continue;
    inputs.push_back(read_curves(argument.file).front());
    plot.lines.push_back({arguments.curvature[k], {}, argument.color});
  }
  if (inputs.empty()) throw Error(ErrorCode::kBadUsage, "--curvature names no curve");
  CurveTurning turning = turning_of(scene.mesh, inputs);
  plot.edge = turning.edge;
  for (std::size_t k = 0; k < inputs.size(); ++k) plot.lines[k].steps = std::move(turning.steps[k]);
  plot.lines.front().behind = inputs.size() > 1;
  const bool shows_detail =
      std::any_of(scene.panels.begin(), scene.panels.end(),
                  [](const Panel& panel) { return panel.fit == Fit::kDetail; });
  if (shows_detail) {
    const Detail detail = turning_detail(scene);
    const PictureCurve last{positions(scene.mesh, inputs.back()), inputs.back().closed};
    plot.shown = stretches_in(last, detail.center, detail.radius);
  }
  return draw_curvature(plot, width, arguments.options.panel_height / 2,
                        arguments.options.background);
}

Image picture_of(const Arguments& arguments) {
  Scene scene;
  scene.mesh = read_mesh(arguments.mesh);
  Image panels = panels_of(arguments, scene);
  if (arguments.curvature.empty()) return panels;
  return stacked(panels, plot_of(arguments, scene, panels.width));
}

int run(int argc, char** argv) {
  CLI::App app("Draws curves on a shaded mesh and writes a PNG file; needs no display.",
               "talweg-picture");
  Arguments a;
  app.add_option("MESH", a.mesh, "Mesh file: " + readable_meshes())->required();
  app.add_option("-o,--output", a.output, "The PNG file to be written")->required();
  app.add_option("--curve", a.curves, "FILE[:rrggbb[:width in pixels]]; may be repeated");
  app.add_option("--panel", a.panels,
                 "CAPTION[|curves=1,2][|fit=FIT][|zoom=Z][|view=x,y,z][|at=x,y,z][|mesh=FILE]"
                 "[|labels=FILE|pieces][|move=x,y,z]; several stand side by side, with meshes and "
                 "colours of their own");
  app.add_option("--fit", a.fit,
                 "The part that a picture without panels shows: auto, curve, mesh, detail");
  app.add_option("--zoom", a.zoom, "Enlarges what --fit chose");
  app.add_option("--view", a.view, "x,y,z: direction from the mesh to the viewer");
  app.add_option("--up", a.up, "x,y,z: direction that points up in the picture");
  app.add_option("--width", a.options.panel_width, "Width of a panel in pixels");
  app.add_option("--height", a.options.panel_height, "Height of a panel in pixels");
  app.add_option("--samples", a.options.supersampling, "Samples per pixel in x and in y");
  app.add_option(
         "--curvature", a.curvature,
         "NAME,NAME: names of the curves, in their order, for a plot of their curvature beneath "
         "the panels; the first is pale, and a curve with the name - is left out")
      ->delimiter(',');
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
  write_png(a.output, picture_of(a));
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

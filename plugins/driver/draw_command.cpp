// talweg draw: a curve through given vertices, straight or along mesh edges.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "ridge_options.hpp"
#include "talweg/core/drawing/draw.hpp"
#include "talweg/core/drawing/marked_points.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/click_file.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/ridges/ridge_snapping.hpp"
#include "talweg/core/strokes/border_ends.hpp"
#include "talweg/intrinsic/error.hpp"
#include "written_points.hpp"

namespace talweg::driver {
namespace {

struct Options {
  std::string mesh;
  std::vector<std::uint32_t> through;
  std::string clicks;  ///< a file of clicks, instead of vertices
  bool closed = false;
  bool straight = false, edges = false;
  std::vector<std::string> outputs;
  std::string repair;
  std::string mesh_units;
  std::string points = "exact";
  std::string border = "leave";
  WrittenPoints written;
  RidgeChoice ridges;
};

/// The points of the mesh through which the curve is drawn.
struct Clicks {
  std::vector<SurfacePoint> points;
  bool closed = false;
  std::vector<std::string> notes;     ///< sentences on how they were read
  bool far = false;                   ///< whether the first sentence is a warning
  std::vector<std::string> extended;  ///< sentences on ends that were extended to the border
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

Clicks given_vertices(const SurfaceMesh& mesh, const RepairMap* map, const Options& options) {
  Clicks clicks;
  clicks.closed = options.closed;
  for (const VertexId v : through_on(mesh, map, options)) {
    clicks.points.push_back(SurfacePoint::at_vertex(mesh.surface(), v));
  }
  return clicks;
}

/// The points of the file, moved to the nearest points of the mesh.
Clicks clicks_of_file(const SurfaceMesh& mesh, const RepairMap* map, const Options& options,
                      const CoordinateFrame& frame, const Progress& progress) {
  CurveInput input = read_clicks(options.clicks, frame);
  input.closed = input.closed || options.closed;
  SnappedCurve snapped = snap(mesh, input, {}, progress);
  Clicks clicks;
  clicks.closed = input.closed;
  std::string moved = snap_warning(snapped.largest_snap_distance, mesh);
  if (!snapped.better_fit.empty()) moved += fmt::format(" It {}.", snapped.better_fit);
  clicks.far = moved_far(snapped.largest_snap_distance, mesh) || !snapped.better_fit.empty();
  if (!moved.empty()) clicks.notes.push_back(moved);
  clicks.notes.insert(clicks.notes.end(), snapped.notes.begin(), snapped.notes.end());
  if (snapped.merged > 0) {
    clicks.notes.push_back(fmt::format("{} clicks lie where the one before lies.", snapped.merged));
  }
  clicks.points = std::move(snapped.points);
  if (map != nullptr) {
    clicks.points = map->on_one_sheet(clicks.points, clicks.closed, mesh.surface());
  }
  for (SurfacePoint& point : clicks.points) point = settled(mesh.surface(), point);
  return clicks;
}

bool is_along_edges(const Options& options) {
  const auto holds_vertices = [](const std::string& output) { return output.ends_with(".txt"); };
  return options.edges || (options.points == "rough" && !options.straight) ||
         std::ranges::any_of(options.outputs, holds_vertices);
}

void check_border(const Options& options) {
  if (border_ends(options.border) == BorderEnds::kLeave || !is_along_edges(options)) return;
  throw Error(
      ErrorCode::kBadUsage,
      "--border snap extends ends to points between vertices, which no path along edges can "
      "reach (--edges, --points rough, a .txt file); leave --border out, or use --straight "
      "and another format.");
}

Drawing path_through(const SurfaceMesh& mesh, const Clicks& clicks, const Options& options,
                     const Progress& progress) {
  DrawOptions own;
  own.closed = clicks.closed;
  if (options.points == "rough") own.tolerance.reset();
  if (options.straight || is_along_edges(options)) own.straight = options.straight;
  return draw(mesh.surface(), clicks.points, own, progress);
}

/// Adds a click on the border beyond each end of the path that stops a little before the border.
/// Returns whether a click was added.
bool lead_to_border(const SurfaceMesh& mesh, const SurfaceCurve& path, Clicks& clicks) {
  SnappedDrawing drawing;
  drawing.curves.push_back(path);
  StraightLines lines(mesh.surface());
  drawing = with_ends_at_border(mesh, std::move(drawing), lines);
  const std::vector<SurfacePoint>& extended = drawing.curves.front().points;
  if (extended.front() != path.points.front())
    clicks.points.insert(clicks.points.begin(), extended.front());
  if (extended.back() != path.points.back()) clicks.points.push_back(extended.back());
  clicks.extended = std::move(drawing.notes);
  return !clicks.extended.empty();
}

/// Moves a drawing and its way-points onto ridges, and adds a sentence on the moves. `marks`: the
/// marks of the drawing's points.
void move_to_ridges(const SurfaceMesh& mesh, const RidgeChoice& choice, Drawing& drawing,
                    std::vector<double>& marks, Clicks& clicks, const Progress& progress) {
  if (choice.strength == 0) return;
  RidgedDrawing ridged = snapped_to_ridges(mesh, std::span(&drawing.curve, 1), {},
                                           {drawing.way_points, {}}, choice.options(), progress);
  drawing.curve = std::move(ridged.curves.front());
  if (!drawing.way_points.empty()) marks = marks_of_points(drawing.curve, ridged.points);
  clicks.extended.push_back(ridged.moves.front().sentence(0));
}

ReadyCurve drawn(const SurfaceMesh& mesh, Clicks& clicks, const Options& options,
                 const CoordinateFrame& frame, const Progress& progress) {
  Drawing drawing = path_through(mesh, clicks, options, progress);
  if (border_ends(options.border) == BorderEnds::kSnap &&
      lead_to_border(mesh, drawing.curve, clicks)) {
    drawing = path_through(mesh, clicks, options, progress);
  }
  std::vector<double> marks = marks_through(drawing.curve, clicks.points);
  move_to_ridges(mesh, options.ridges, drawing, marks, clicks, progress);
  ReadyCurve made = ready(mesh, drawing.curve, 0, options.written, frame);
  if (options.points == "exact" && !made.spacing) {
    made.curve.exact = std::move(marks);
  }
  return made;
}

/// Prints the sentences on how the clicks of a file were read. A warning that the clicks lie far
/// away comes first, and on the standard error.
void tell_clicks(const Clicks& clicks, bool quiet) {
  clear_progress_bar();
  for (std::size_t k = 0; k < clicks.notes.size() && !quiet; ++k) {
    if (k == 0 && clicks.far) {
      std::fprintf(stderr, "talweg: warning: %s\n", clicks.notes[k].c_str());
    } else {
      std::fprintf(text_stream(), "%s\n", clicks.notes[k].c_str());
    }
  }
}

/// Prints the names of the files whose points are a stroke because the format has no way-points.
void tell_strokes(const Options& options) {
  std::string names;
  for (const std::string& output : options.outputs) {
    if (!holds_way_points(output)) names += (names.empty() ? "" : ", ") + output;
  }
  if (names.empty() || options.points != "exact" || !options.written.resample.empty()) return;
  std::fprintf(
      text_stream(),
      "%s: written as a stroke, because only .json, .vtp and .vtk files hold way-points.\n",
      names.c_str());
}

int run(const Options& options, const GlobalOptions& global) {
  check_unit(options.mesh_units);
  check_points(options.written);
  check_border(options);
  if (options.through.empty() && options.clicks.empty()) {
    throw Error(ErrorCode::kBadUsage, "--through is required, or --clicks.");
  }
  FilePlan files;
  files.reads("the mesh", options.mesh);
  files.reads("--clicks", options.clicks);
  files.writes("-o", options.outputs, check_curve_name);
  files.check();
  const ReadMesh read = read_and_repair(options.mesh, options.repair);
  const SurfaceMesh mesh = SurfaceMesh::open(read.lists);
  const CoordinateFrame frame = with_unit(read.lists.frame(), options.mesh_units);
  std::vector<PlacedCurve> curves;
  std::vector<std::string> notes;
  try {
    const Progress progress = progress_bar(global.quiet);
    Clicks clicks = options.clicks.empty()
                        ? given_vertices(mesh, read.map.get(), options)
                        : clicks_of_file(mesh, read.map.get(), options, frame, progress);
    ReadyCurve made = drawn(mesh, clicks, options, frame, progress);
    tell_clicks(clicks, global.quiet);
    notes = std::move(clicks.extended);
    if (made.spacing) notes.push_back(spacing_text(made));
    curves.push_back(in_file_numbers(read.map.get(), std::move(made.curve)));
  } catch (const Error& error) {
    rethrow_with_weld_hint(error, read.lists);
  }
  clear_progress_bar();
  for (const std::string& output : options.outputs) {
    write_output(output, curve_bytes(output, curves, frame));
  }
  if (global.quiet) return kDone;
  tell_strokes(options);
  notes.insert(notes.end(), read.changes.begin(), read.changes.end());
  for (const std::string& sentence : notes) std::fprintf(text_stream(), "%s\n", sentence.c_str());
  return kDone;
}

}  // namespace

Command add_draw(CLI::App& app, const GlobalOptions& global) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "draw", "Draw a curve through mesh vertices: straight over the faces, or along edges");
  command->add_option("mesh", options->mesh, mesh_help())->required();
  CLI::Option* through =
      command
          ->add_option("--through", options->through,
                       "Vertex numbers from 0, separated by commas, in the order of drawing")
          ->delimiter(',');
  command
      ->add_option("--clicks", options->clicks,
                   "Instead: a list or curve of 3D Slicer (.fcsv or .mrk.json), whose points are "
                   "moved to the nearest points of the mesh")
      ->excludes(through);
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
                   "exact: the vertices are way-points, which a smoothed curve passes through; "
                   "rough: the whole path is a stroke, as of a trembling hand")
      ->check(CLI::IsMember({"exact", "rough"}))
      ->capture_default_str();
  command
      ->add_option("--border", options->border,
                   "snap: an end that stops within two edges of the mesh's border is extended "
                   "straight to a further way-point on the border; leave: the end stays")
      ->check(CLI::IsMember({"snap", "leave"}))
      ->capture_default_str();
  command
      ->add_option("-o,--output", options->outputs,
                   "Curve: .obj, .ply, .vtp, .vtk, .mrk.json, .border, .fcsv, .txt (vertex "
                   "numbers) or .json")
      ->required();
  add_ridge_options(*command, options->ridges);
  add_repair_option(*command, options->repair);
  add_unit_option(*command, options->mesh_units);
  add_point_options(*command, options->written);
  return [options, &global] { return run(*options, global); };
}

}  // namespace talweg::driver

// talweg measure: lengths and curvatures of curves on a mesh, and the distance between two curves.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "measure_text.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/measure/curve_measurement.hpp"

namespace talweg::driver {
namespace {

struct MeasureOptions {
  std::string mesh;
  std::string curve;
  std::string other;
  std::string report;
  std::string repair;
  std::string mesh_units;
  CurveMeasurementOptions measurement;
};

CurveMeasurement measure(const MeasureOptions& options, const Progress& progress, bool quiet) {
  check_unit(options.mesh_units);
  options.measurement.validate();
  ReadMesh read = read_and_repair(options.mesh, options.repair);
  const std::size_t polygons = read.lists.polygon_count;
  const CoordinateFrame frame = with_unit(read.lists.frame(), options.mesh_units);
  const SurfaceMesh mesh = SurfaceMesh::open(std::move(read.lists));
  SnappedDrawing drawing = read_drawing(options.curve, mesh, read.map.get(), frame);
  lead_with_far_move(drawing, quiet);
  SnappedDrawing other;
  if (!options.other.empty()) {
    other = read_drawing(options.other, mesh, read.map.get(), frame);
    lead_with_far_move(other, quiet);
    drawing.notes.insert(drawing.notes.end(), other.notes.begin(), other.notes.end());
    if (other.largest_snap_distance > drawing.largest_snap_distance) {
      drawing.largest_snap_distance = other.largest_snap_distance;
      drawing.moved = other.moved;
      drawing.far = other.far;
    }
  }
  CurveMeasurement m =
      measure_curves(mesh, drawing.curves, other.curves, options.measurement, progress);
  drawing.gaps = {};  // the joined curve itself is measured
  const std::vector<std::string> reading = reading_warnings(drawing, polygons);
  drawing.add_to(m.warnings, reading);
  m.warnings.insert(m.warnings.end(), read.changes.begin(), read.changes.end());
  return m;
}

}  // namespace

Command add_measure(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand("measure",
                                         "Length, geodesic curvature, bending and self-contacts of "
                                         "curves; with a second file also how far "
                                         "apart they lie along the surface, both ways");
  command->add_option("mesh", o->mesh, mesh_help())->required();
  command
      ->add_option("curve", o->curve,
                   "Curves: .obj, .ply, .vtp, .vtk, .mrk.json, .border, .fcsv, .txt (vertex "
                   "numbers) or .json")
      ->required();
  command->add_option("other", o->other,
                      "Curves to compare with: one by one in their order if the numbers of curves "
                      "are equal, else all together");
  command->add_option(
      "--edge", o->measurement.edge,
      "Length of the windows in which turning is measured, mesh units; by default the "
      "mean edge near each curve. To compare curves, give the same length for all");
  command->add_option("--report", o->report, "All measures, as JSON");
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  return [o, &global] {
    FilePlan files;
    files.reads("the mesh", o->mesh);
    files.reads("the curve", o->curve);
    files.reads("the other curve", o->other);
    files.writes("--report", o->report);
    files.check();
    const CurveMeasurement m = measure(*o, progress_bar(global.quiet), global.quiet);
    clear_progress_bar();
    if (!o->report.empty()) write_output(o->report, to_json(entries_of(m), curve_entries_of(m)));
    const bool table = global.verbose || o->report.empty();
    if (table && !global.quiet)
      std::fputs(measure_table(m, o->curve, o->other).c_str(), text_stream());
    return static_cast<int>(kDone);
  };
}

}  // namespace talweg::driver

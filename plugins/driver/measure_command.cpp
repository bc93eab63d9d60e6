// talweg measure: what curves on a mesh measure, and how far apart two of them lie.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
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
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

struct MeasureOptions {
  std::string mesh;
  std::string curve;
  std::string other;
  std::string report;
  std::string repair;
  std::string mesh_units = "mm";
  std::optional<double> edge;
};

void count_contacts(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    MeasuredCurve& measured) {
  for (const SelfContact& contact : self_contacts(mesh.surface(), curves)) {
    measured.contacts.push_back(mesh.position(contact.at));
    if (contact.stretch) ++measured.stretches;
  }
}

MeasuredCurve measure_one(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                          std::optional<double> edge) {
  MeasuredCurve measured;
  measured.points = curve.points.size();
  measured.closed = curve.closed;
  measured.edge = edge ? *edge : edge_length_near(mesh.surface(), curve);
  measured.measures = measure_curve(mesh.surface(), curve, measured.edge);
  measured.max_at = mesh.position(curve.points[measured.measures.max_at]);
  count_contacts(mesh, std::span(&curve, 1), measured);
  return measured;
}

MeasuredFile measure_file(const SurfaceMesh& mesh, const std::string& name,
                          const std::vector<SurfaceCurve>& curves, std::optional<double> edge) {
  MeasuredFile file{name, {}, {}};
  for (const SurfaceCurve& curve : curves) file.curves.push_back(measure_one(mesh, curve, edge));
  file.total = file.curves.front();
  if (curves.size() == 1) return file;
  file.total.contacts.clear();
  file.total.stretches = 0;
  count_contacts(mesh, curves, file.total);
  for (const MeasuredCurve& c : std::span(file.curves).subspan(1)) {
    MeasuredCurve& total = file.total;
    total.points += c.points;
    total.closed = total.closed && c.closed;
    total.measures.length += c.measures.length;
    total.measures.total_curvature += c.measures.total_curvature;
    total.measures.signed_curvature += c.measures.signed_curvature;
    total.measures.bending += c.measures.bending;
    total.measures.window_turning =
        std::max(total.measures.window_turning, c.measures.window_turning);
    total.measures.window_turning_2 =
        std::max(total.measures.window_turning_2, c.measures.window_turning_2);
    total.edge += c.edge;
    if (c.measures.max_curvature > total.measures.max_curvature) {
      total.measures.max_curvature = c.measures.max_curvature;
      total.max_at = c.max_at;
    }
  }
  file.total.edge /= static_cast<double>(curves.size());
  return file;
}

/// Computes the deviation of all curves from those of the pairs: maxima, and means weighted by
/// length.
MeasuredDeviation all_of(const Measurement& m) {
  MeasuredDeviation all = m.deviations.front();
  double to = 0, from = 0;
  for (std::size_t i = 0; i < m.deviations.size(); ++i) {
    const MeasuredDeviation& d = m.deviations[i];
    if (std::max(d.to_max, d.from_max) > std::max(all.to_max, all.from_max)) all.at = d.at;
    all.to_max = std::max(all.to_max, d.to_max);
    all.from_max = std::max(all.from_max, d.from_max);
    to += d.to_mean * m.file.curves[i].measures.length;
    from += d.from_mean * m.other->curves[i].measures.length;
  }
  all.to_mean = to / m.file.total.measures.length;
  all.from_mean = from / m.other->total.measures.length;
  return all;
}

void compare(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
             std::span<const SurfaceCurve> others, const Progress& progress, Measurement& m) {
  DeviationMeter meter(mesh);
  const auto between = [&](std::span<const SurfaceCurve> a, std::span<const SurfaceCurve> b) {
    const SurfaceDeviation d = meter.measure(a, b, progress);
    return MeasuredDeviation{d.to_drawn.max, d.to_drawn.mean, d.from_drawn.max, d.from_drawn.mean,
                             mesh.position(d.larger().at)};
  };
  if (curves.size() == others.size()) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      m.deviations.push_back(between(curves.subspan(i, 1), others.subspan(i, 1)));
    }
    m.deviation = all_of(m);
  } else {
    m.deviation = between(curves, others);
    m.warnings.push_back(std::to_string(curves.size()) + " curves are compared with " +
                         std::to_string(others.size()) + ": all together, not one by one.");
  }
  if (!std::isfinite(std::max(m.deviation.to_max, m.deviation.from_max))) {
    m.warnings.emplace_back(
        "Some curves lie on parts of the mesh that are not connected: their deviation is "
        "infinite.");
  }
}

Measurement measure(const MeasureOptions& options, const Progress& progress, bool quiet) {
  const LengthUnit unit = LengthUnit::named(options.mesh_units);
  if (options.edge && !(*options.edge > 0 && std::isfinite(*options.edge))) {
    throw Error(ErrorCode::kBadUsage, "--edge is a length: a finite number above 0.");
  }
  ReadMesh read = read_and_repair(options.mesh, options.repair);
  const std::size_t polygons = read.lists.polygon_count;
  const SurfaceMesh mesh = SurfaceMesh::open(std::move(read.lists));
  SnappedDrawing drawing = read_drawing(options.curve, mesh, read.map.get(), unit);
  lead_with_far_move(drawing, quiet);
  Measurement m{mesh.surface().face_count(),
                mesh.surface().vertex_count(),
                measure_file(mesh, options.curve, drawing.curves, options.edge),
                {},
                {},
                {},
                {}};
  if (!options.other.empty()) {
    const SnappedDrawing other = read_drawing(options.other, mesh, read.map.get(), unit);
    lead_with_far_move(other, quiet);
    if (other.largest_snap_distance > drawing.largest_snap_distance) {
      drawing.largest_snap_distance = other.largest_snap_distance;
      drawing.moved = other.moved;
      drawing.far = other.far;
    }
    m.other = measure_file(mesh, options.other, other.curves, options.edge);
    compare(mesh, drawing.curves, other.curves, progress, m);
  }
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
  command->add_option("mesh", o->mesh, "Mesh: OBJ, OFF, PLY, STL or OM")->required();
  command
      ->add_option("curve", o->curve,
                   "Curves: .obj, .ply, .vtp, .vtk, .mrk.json, .txt (vertex numbers) or .json")
      ->required();
  command->add_option("other", o->other,
                      "Curves to compare with: as many are compared one by one in their order, "
                      "more or fewer all together");
  command->add_option(
      "--edge", o->edge,
      "Length of the windows in which turning is measured, mesh units; by default the "
      "mean edge near each curve. To compare curves give all the same");
  command->add_option("--report", o->report, "What was measured, as JSON");
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  return [o, &global] {
    FilePlan files;
    files.reads("the mesh", o->mesh);
    files.reads("the curve", o->curve);
    files.reads("the other curve", o->other);
    files.writes("--report", o->report);
    files.check();
    const Measurement m = measure(*o, progress_bar(global.quiet), global.quiet);
    clear_progress_bar();
    if (!o->report.empty()) write_output(o->report, measure_json(m));
    const bool table = global.verbose || o->report.empty();
    if (table && !global.quiet) std::fputs(measure_table(m).c_str(), text_stream());
    return static_cast<int>(kDone);
  };
}

}  // namespace talweg::driver

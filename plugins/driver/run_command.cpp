// talweg run PLUGIN: any plugin, with options made from its description.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "field_file.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "plugin_attributes.hpp"
#include "plugin_host.hpp"
#include "plugin_meshes.hpp"
#include "plugin_options.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/drawing/better_fit.hpp"
#include "talweg/core/drawing/corner_coordinates.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/io/border_file.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

/// The input and output files.
struct Files {
  std::string mesh;
  std::vector<std::string> curves;
  std::vector<std::string> outputs;
  std::string report;
  std::string meshes;
  std::string map;
  bool tag = false;
  std::map<std::string, std::string> fields;  ///< by name
  std::string repair;                         ///< steps; empty for none
  std::string mesh_units;
};

void plan(const Files& files, const PluginOptions& options) {
  check_unit(files.mesh_units);
  FilePlan plan;
  plan.reads("the mesh", files.mesh);
  plan.reads("--curve", files.curves);
  for (const auto& [option, path] : options.files()) plan.reads(option, path);
  plan.writes("-o", files.outputs, check_curve_name);
  plan.writes("--report", files.report);
  plan.writes("--write-mesh", files.meshes, check_mesh_name);
  plan.writes("--map", files.map);
  if (files.tag) check_tag(files.meshes);
  for (const auto& [name, path] : files.fields) plan.writes(option_name("write_" + name), path);
  plan.check();
}

bool gives(const talweg_plugin& plugin, std::uint32_t kind) {
  for (std::uint32_t k = 0; k < plugin.output_count; ++k) {
    if (plugin.outputs[k]->kind == kind) return true;
  }
  return false;
}

void add_files(CLI::App& app, const talweg_plugin& plugin, Files& files) {
  app.add_option("mesh", files.mesh, mesh_help())->required();
  add_repair_option(app, files.repair);
  add_unit_option(app, files.mesh_units);
  if ((plugin.flags & TALWEG_TAKES_CURVES) != 0) {
    app.add_option(
           "--curve", files.curves,
           "Curves: .obj, .ply, .vtp, .vtk, .mrk.json, .fcsv, .txt (vertex numbers) or .json; may "
           "be given several times")
        ->required();
  }
  if (gives(plugin, TALWEG_OUTPUT_CURVES)) {
    app.add_option("-o,--output", files.outputs,
                   "Resulting curves; the ending chooses the format; may be given several times");
  }
  if (gives(plugin, TALWEG_OUTPUT_REPORT)) {
    app.add_option("--report", files.report, "The report, as JSON");
  }
  if (gives(plugin, TALWEG_OUTPUT_MESH)) {
    app.add_option("--write-mesh", files.meshes,
                   "The resulting mesh: OBJ, OFF, PLY, STL, VTK or VTP; several are OUT-0.ply, "
                   "OUT-1.ply, ...");
  }
  if (meshes_of(plugin) != nullptr) {
    app.add_option("--map", files.map,
                   "JSON: where every vertex and face of the meshes comes from, and the curves' "
                   "vertices");
    app.add_flag(
        "--tag", files.tag,
        "Also write the curves' edges into the mesh: element edge of a .ply, l of an .obj, lines "
        "of a .vtk or .vtp");
  }
  for (std::uint32_t k = 0; k < plugin.output_count; ++k) {
    const talweg_output& output = *plugin.outputs[k];
    const bool of_triangles = output.kind == TALWEG_OUTPUT_TRIANGLE_FIELD;
    if (output.kind != TALWEG_OUTPUT_VERTEX_FIELD && !of_triangles) continue;
    app.add_option(
        option_name(std::string("write_") + output.name), files.fields[output.name],
        fmt::format("{}{}{}: one number per {}. {}", output.label, *output.unit == 0 ? "" : ", ",
                    output.unit, of_triangles ? "triangle" : "vertex", output.doc));
  }
}

std::string list_text(const host::ReportEntry& entry) {
  if (entry.type == TALWEG_VALUE_TEXT) return fmt::format("{}", fmt::join(entry.texts, " "));
  return fmt::format("{:.6g}", fmt::join(entry.numbers, " "));
}

/// Reads the curves of the files in the numbers of the mesh, and adds sentences on the conversion.
std::vector<host::Curve> curves_on(const ReadMesh& mesh, const Files& files,
                                   std::vector<std::string>& notes) {
  const CoordinateFrame frame = with_unit(mesh.lists.frame(), files.mesh_units);
  Surface surface;
  if (mesh.map != nullptr) {
    surface = Surface::from_triangles(mesh.lists.points.size(), mesh.lists.triangles);
  }
  std::vector<host::Curve> curves;
  for (const std::string& path : files.curves) {
    for (CurveInput& curve : read_curves(path, frame)) {
      notes.insert(notes.end(), curve.notes.begin(), curve.notes.end());
      if (mesh.map != nullptr) curve = mesh.map->to_repaired(curve, surface);
      if (const auto* between = std::get_if<std::vector<CornerCoordinates>>(&curve.points)) {
        if (surface.face_count() == 0) {
          surface = Surface::from_triangles(mesh.lists.points.size(), mesh.lists.triangles);
        }
        curve.points = in_faces(surface, *between);  // plugins take points in faces
      }
      curves.push_back(host_curve(curve));
    }
  }
  return curves;
}

/// A `.border` names the vertices around each point, so the mesh must stay in memory to the end.
bool writes_borders(const Files& files) {
  return std::any_of(files.outputs.begin(), files.outputs.end(), [](const std::string& output) {
    return lower_extension(output) == ".border";
  });
}

void add_corners(PlacedCurve& curve, const MeshLists& lists) {
  curve.vertex_count = lists.points.size();
  for (const FaceCoordinates& at : curve.faces) {
    std::array<VertexId, 3>& corners = curve.corners.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c] = VertexId{std::size_t{lists.triangles.at(at.face.index())[c]}};
    }
  }
}

/// One number per vertex of the file. A split vertex has the number of its first copy.
std::vector<double> per_file_vertex(const RepairMap* map, const std::vector<double>& values) {
  const bool repaired = map != nullptr && values.size() == map->vertex_count();
  return repaired ? map->to_file_vertices(values) : values;
}

void write_named_field(const std::string& name, const std::string& path,
                       const talweg_plugin& plugin, const host::Results& results,
                       const RepairMap* map) {
  bool written = false;
  for (const host::Field& field : results.fields) {
    if (field.name != name) continue;
    write_field(path, per_file_vertex(map, field.values));
    written = true;
  }
  if (!written) {
    throw Error(ErrorCode::kBadFile, std::string(plugin.id) + " gave no field " + name + ".");
  }
}

void write_report(const std::string& path, const host::Results& results) {
  std::vector<std::vector<ReportEntry>> reports;
  for (std::size_t c = 0; c < results.curves.size(); ++c) {
    reports.push_back(entries_of(results, static_cast<std::int64_t>(c)));
  }
  write_output(path, to_json(entries_of(results, -1), reports));
}

/// The labels left and right of each curve, if the report has them.
std::vector<SideLabels> sides_of(const host::Results& results) {
  std::vector<SideLabels> sides;
  for (std::size_t c = 0; c < results.curves.size(); ++c) {
    const std::string key = fmt::format("borders.{}.", c);
    if (results.find(key + "left") == nullptr || results.find(key + "right") == nullptr) return {};
    sides.push_back({static_cast<std::int64_t>(results.number(key + "left")),
                     static_cast<std::int64_t>(results.number(key + "right"))});
  }
  return sides;
}

void write_results(const Files& files, const talweg_plugin& plugin, const host::Results& results,
                   const PluginMeshes& meshes, const ReadMesh& mesh, const CoordinateFrame& frame) {
  const RepairMap* map = mesh.map.get();
  std::vector<PlacedCurve> curves;
  for (const host::Curve& curve : results.curves) {
    PlacedCurve placed = placed_curve(curve);
    if (!mesh.lists.triangles.empty()) add_corners(placed, mesh.lists);
    curves.push_back(in_file_numbers(map, std::move(placed)));
  }
  const std::vector<SideLabels> sides = sides_of(results);
  OutputAttempts attempts;
  for (const std::string& output : files.outputs) {
    attempts.make([&] {
      write_output(output, sides.empty() ? curve_bytes(output, curves, frame)
                                         : border_bytes(output, curves, sides, frame));
    });
  }
  for (const auto& field : files.fields) {
    const std::string& path = field.second;
    if (path.empty()) continue;
    attempts.make([&] { write_named_field(field.first, path, plugin, results, map); });
  }
  if (!files.report.empty()) attempts.make([&] { write_report(files.report, results); });
  if (!files.meshes.empty() && meshes.empty()) {
    throw Error(ErrorCode::kBadFile, std::string(plugin.id) + " gave no mesh.");
  }
  if (!files.meshes.empty()) attempts.make([&] { meshes.write(files.meshes, files.tag); });
  if (!files.map.empty()) attempts.make([&] { meshes.write_map(files.map, files.meshes); });
  attempts.finish();
}

bool writes_nothing(const Files& files) {
  for (const auto& [name, path] : files.fields) {
    if (!path.empty()) return false;
  }
  return files.outputs.empty() && files.report.empty() && files.meshes.empty() && files.map.empty();
}

/// Rethrows a plugin's error with a hint, for which the mesh is read again.
[[noreturn]] void rethrow_with_hint(const host::Error& error, const Files& files) {
  try {
    rethrow(error);
  } catch (const Error& translated) {
    if (translated.code() != ErrorCode::kBadCurve) throw;
    rethrow_with_weld_hint(translated, read_and_repair(files.mesh, files.repair).lists);
  }
}

/// Writes the plugin's warning that the drawing was moved far before everything else.
void lead_with_far_results(const host::Results& results) {
  for (const host::ReportEntry& entry : results.report) {
    if (entry.curve >= 0 || entry.key != "warnings") continue;
    for (const std::string& warning : entry.texts) {
      const bool fits_elsewhere = warning.find(kWouldFit) != warning.npos;
      if (!warning.starts_with(kFarFromMesh) && !fits_elsewhere) continue;
      std::fprintf(stderr, "talweg: warning: %s\n", warning.c_str());
    }
  }
}

/// Reads the mesh, and repairs it unless the plugin repairs meshes itself.
ReadMesh mesh_for(const talweg_plugin& plugin, const PluginOptions& options, const Files& files,
                  MeshAttributes& attributes) {
  const talweg_meshes* extension = meshes_of(plugin);
  if (extension != nullptr && (extension->takes & TALWEG_TAKES_ANY_MESH) != 0) {
    ReadMesh mesh;
    mesh.lists = read_mesh(files.mesh, attributes);
    return mesh;
  }
  return read_and_repair(files.mesh, options.repairs() ? "" : files.repair, attributes);
}

/// The plugin's warnings on its repair.
std::vector<std::string> repairs_in(const host::Results& results) {
  std::vector<std::string> sentences;
  for (const char* key : {"warnings", "repair.changes"}) {
    const host::ReportEntry* entry = results.find(key);
    if (entry == nullptr) continue;
    for (const std::string& text : entry->texts) {
      if (text.starts_with("Repair: ")) sentences.push_back(text);
    }
  }
  return sentences;
}

int run_plugin(const talweg_plugin& plugin, const Files& files, const PluginOptions& options,
               const GlobalOptions& global) {
  const host::Services services(
      "talweg", version(), progress_bar(global.quiet),
      [&global](std::uint32_t severity, const char* message) {
        if (global.verbose && !global.quiet && severity >= TALWEG_LOG_INFO) {
          std::fprintf(stderr, "talweg: %s\n", message);
        }
      });
  host::Results results;
  ReadMesh mesh;
  CoordinateFrame frame;
  PluginMeshes meshes;
  try {
    host::Instance instance(plugin, services);
    options.apply(instance);
    if (options.repairs()) set_repair(instance, files.repair);
    MeshAttributes attributes;
    mesh = mesh_for(plugin, options, files, attributes);
    set_mesh(instance, mesh.lists);
    const bool single = mesh.lists.single_precision;
    frame = with_unit(mesh.lists.frame(), files.mesh_units);
    std::vector<std::string> notes;
    const std::vector<host::Curve> curves = curves_on(mesh, files, notes);
    mesh.changes.insert(mesh.changes.end(), notes.begin(), notes.end());
    if (!writes_borders(files)) mesh.lists = {};
    if (!curves.empty()) instance.set_curves(curves);
    host::Wanted wanted;
    wanted.meshes = !files.meshes.empty() || !files.map.empty();
    const talweg_meshes* extension = wanted.meshes ? meshes_of(plugin) : nullptr;
    if (extension != nullptr && (extension->takes & TALWEG_TAKES_ATTRIBUTES) != 0) {
      instance.set_attributes(host_attributes(attributes));
    }
    for (const auto& [name, path] : files.fields) {
      wanted.vertex_fields = wanted.vertex_fields || !path.empty();
    }
    results = instance.run(wanted);
    if (wanted.meshes) meshes = PluginMeshes(instance, results, attributes, single, frame.space);
  } catch (const host::Error& error) {
    if (error.status() != TALWEG_CANCELLED) rethrow_with_hint(error, files);
    clear_progress_bar();
    std::fprintf(stderr, "talweg: cancelled; nothing was written.\n");
    return kCancelled;
  }
  clear_progress_bar();
  if (!global.quiet) lead_with_far_results(results);
  write_results(files, plugin, results, meshes, mesh, frame);
  for (std::string& change : repairs_in(results)) mesh.changes.push_back(std::move(change));
  for (const std::string& change : mesh.changes) {
    if (!global.quiet) fmt::print(text_stream(), "{}\n", change);
  }
  if (!global.quiet && (global.verbose || writes_nothing(files))) {
    for (const host::ReportEntry& entry : results.report) {
      if (entry.curve < 0) fmt::print(text_stream(), "{:<28}{}\n", entry.key, list_text(entry));
    }
  }
  const std::string termination = results.text("termination");
  return termination.empty() || termination == "converged" ? kDone : kNotConverged;
}

/// Parses the arguments after `run PLUGIN` by the plugin's own options.
int parse_and_run(std::vector<std::string> arguments, const GlobalOptions& given) {
  GlobalOptions global = given;
  const talweg_plugin& plugin = plugin_named(arguments.front());
  CLI::App app(fmt::format("{}: {}", plugin.label, plugin.doc),
               std::string("talweg run ") + plugin.id);
  Files files;
  add_files(app, plugin, files);
  const PluginOptions options(app, plugin);
  app.add_flag("-q,--quiet", global.quiet, "Print errors only");
  app.add_flag("-v,--verbose", global.verbose, "Print the report and what the plugin logs");
  arguments.erase(arguments.begin());
  app.allow_extras();  // unknown arguments get a message with a suggestion
  check_values(app, arguments);
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 expects
  try {
    app.parse(arguments);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);  // --help
  } catch (const CLI::ParseError& error) {
    for (const std::string& extra : app.remaining()) refuse_unexpected(app, extra);
    throw Error(ErrorCode::kBadUsage,
                error.what() + std::string(" (see talweg run ") + plugin.id + " --help)");
  }
  for (const std::string& extra : app.remaining()) refuse_unexpected(app, extra);
  plan(files, options);
  return run_plugin(plugin, files, options, global);
}

}  // namespace

Command add_run(CLI::App& app, const GlobalOptions& global) {
  CLI::App* command = app.add_subcommand(
      "run",
      "Run any plugin on a mesh: talweg run PLUGIN MESH ...; talweg run PLUGIN --help tells "
      "its options");
  command->prefix_command();
  command->fallthrough(false);
  return [command, &global]() -> int {
    const std::vector<std::string> arguments = command->remaining();
    if (arguments.empty()) {
      throw Error(ErrorCode::kBadUsage, "A plugin is required (see talweg plugins).");
    }
    return parse_and_run(arguments, global);
  };
}

}  // namespace talweg::driver

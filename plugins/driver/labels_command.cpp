// talweg labels: all borders of a segmentation, smoothed together.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "drawing_file.hpp"
#include "file_plan.hpp"
#include "methods/budget_choice.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/io/border_file.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/label_writer.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/labels/label_report.hpp"
#include "talweg/core/labels/returned_labels.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "written_points.hpp"

namespace talweg::driver {
namespace {

struct LabelsOptions {
  std::string mesh;
  std::string labels;
  std::vector<std::string> outputs;
  std::string labels_out;
  std::string labels_per;
  std::string cut;
  std::string cut_labels;
  std::string report;
  std::string repair;
  std::string property;
  std::string junctions = "fixed";
  std::string ends = "stay";
  std::string mesh_units;
  WrittenPoints written;
  LabelNetworkOptions network;
  std::optional<double> budget, budget_work;
};

/// The budget of the options, minus the time `ms` that reading took.
Budget budget_of(const LabelsOptions& o, double ms) {
  constexpr double kUsedUp = 1e-9;
  const std::vector<talweg_parameter> descriptions = plugins::budget_parameters();
  plugin::Parameters parameters(descriptions);
  try {
    if (o.budget) parameters.set_number("budget", *o.budget);
    if (o.budget_work) parameters.set_number("budget_work", *o.budget_work);
  } catch (const plugin::Failure& failure) {
    throw Error(ErrorCode::kBadUsage, failure.what());
  }
  Budget budget = plugins::budget_of(parameters);
  if (budget.seconds) *budget.seconds = std::max(kUsedUp, *budget.seconds - ms / 1000);
  return budget;
}

/// The labels of the file's faces. A face that the repair dropped has its old label, or, if labels
/// are per vertex, the old label of its first corner.
std::vector<std::int64_t> of_file_faces(const std::vector<std::int64_t>& labels,
                                        const RepairMap* map, const ReadLabels& read,
                                        const std::string& mesh) {
  if (map == nullptr) return labels;
  const bool by_face = read.of_file.size() == map->file_face_count();
  std::optional<MeshLists> lists;
  return map->to_file_faces(labels, [&](std::size_t f) {
    if (by_face) return read.of_file[f];
    if (!lists) lists = read_mesh(mesh);
    return read.of_file[lists->triangles[f][0]];
  });
}

bool are_of_faces(const LabelsOptions& o, std::size_t labels, std::size_t faces) {
  return o.labels_per.empty() ? labels == faces : o.labels_per == "face";
}

/// The new labels in the order of the mesh's file. Labels that would be lost are named.
LabelOutput new_labels(const LabelsOptions& o, const LabelNetwork& network, const Surface& surface,
                       const RepairMap* map, const ReadLabels& read,
                       std::vector<std::string>& warnings) {
  LabelOutput output;
  const bool by_face = read.labels.size() == surface.face_count();
  output.of_faces = are_of_faces(o, read.labels.size(), surface.face_count());
  output.names = read.names;
  output.colors = read.colors;
  if (output.of_faces) {
    output.labels = of_file_faces(network.face_labels, map, read, o.mesh);
  } else {
    output.labels = labels_of_vertices(network, surface, read.labels);
    if (map != nullptr) output.labels = map->to_file_vertices(output.labels);
  }
  const std::vector<LostLabel> lost =
      give_back(map == nullptr ? read.labels : read.of_file, network.face_labels, output.labels);
  if (!lost.empty()) {
    const std::string note = note_on_lost(lost, by_face, output.of_faces, read.names);
    const char* other = by_face == output.of_faces ? "."
                        : by_face                  ? " (use --labels-per face)."
                                                   : " (use --labels-per vertex).";
    warnings.push_back(note + other);
  }
  std::size_t alone = 0;
  for (std::size_t v = 0; by_face && !output.of_faces && v < surface.vertex_count(); ++v) {
    if (!surface.halfedge(VertexId{v}).valid()) ++alone;
  }
  if (alone > 0) {
    warnings.push_back(
        fmt::format("{} vertices of the mesh are in no face; their new label is 0.", alone));
  }
  return output;
}

std::string bytes_of(const LabelsOptions& o, const LabelOutput& output) {
  MeshAttributes attributes;
  MeshLists lists;
  if (!is_label_list(o.labels_out)) lists = read_mesh(o.mesh, attributes);
  return label_bytes(o.labels_out, output, lists, attributes);
}

std::string summary_of(const LabelNetwork& network, double ms) {
  const SmoothingReport& t = network.total;
  std::string text = fmt::format(
      "{} regions, {} borders, {} junctions; {} borders got a smaller slack, {} stayed as given\n",
      network.regions.size(), network.borders.size(), network.junctions, network.tightened,
      network.as_drawn);
  if (network.moved > 0) {
    text += fmt::format(
        "{} junctions and ends moved; at all that may move the sum of the borders' unit tangents "
        "has the mean length {:.3g}, was {:.3g}\n",
        network.moved, network.imbalance_after, network.imbalance_before);
  }
  text += fmt::format("total curvature {:.6g} rad, was {:.6g}; length {:.6g}, was {:.6g}\n",
                      t.after.total_curvature, t.before.total_curvature, t.after.length,
                      t.before.length);
  text += fmt::format("deviation at most {:.6g} to the labels' borders, {:.6g} from them\n",
                      t.deviation_to_drawn_max, t.deviation_from_drawn_max);
  return text + fmt::format("{:.1f} ms\n", ms);
}

/// Writes the cut mesh with the attributes of its file, and with the labels as a property of its
/// faces if the format has such properties. Moves the lists out of the cut.
void write_cut(const std::string& path, LabelNetwork& network, const SurfaceMesh& mesh,
               const MeshAttributes& of_file) {
  MeshPart part = std::move(take_apart(mesh, std::move(network.cut), of_file, {}).parts.front());
  MeshAttributes& attributes = part.attributes;
  AttributeColumn labels = label_column(network.cut_labels);
  std::erase_if(attributes.faces,
                [&](const AttributeColumn& column) { return column.name == labels.name; });
  attributes.faces.push_back(std::move(labels));
  write_output(path, mesh_bytes(path, part.lists, attributes).bytes);
}

void write(const LabelsOptions& o, LabelNetwork& network, const SurfaceMesh& mesh,
           const RepairMap* map, const MeshAttributes& attributes,
           const std::vector<std::string>& warnings, const ReadLabels& labels,
           const LabelOutput& returned, const CoordinateFrame& frame) {
  std::vector<PlacedCurve> placed;
  std::vector<SideLabels> sides;
  for (const SmoothedBorder& border : network.borders) {
    sides.push_back({border.border.labels[0], border.border.labels[1]});
    ReadyCurve made = ready(mesh, border.border.curve, placed.size(), o.written, frame);
    placed.push_back(in_file_numbers(map, std::move(made.curve)));
  }
  OutputAttempts attempts;
  for (const std::string& output : o.outputs) {
    attempts.make([&] { write_output(output, border_bytes(output, placed, sides, frame)); });
  }
  const auto write_text = [&](const std::string& path, const auto& text) {
    if (!path.empty()) attempts.make([&] { write_output(path, text()); });
  };
  write_text(o.labels_out, [&] { return bytes_of(o, returned); });
  if (!o.cut.empty()) attempts.make([&] { write_cut(o.cut, network, mesh, attributes); });
  write_text(o.cut_labels, [&] {
    LabelOutput exact;
    exact.labels = network.cut_labels;
    exact.of_faces = true;
    return label_bytes(o.cut_labels, exact, {});
  });
  write_text(o.report, [&] {
    return to_json(entries_of(network, warnings, labels.names), curve_entries_of(network));
  });
  attempts.finish();
}

void check_files(const LabelsOptions& o) {
  FilePlan files;
  files.reads("the mesh", o.mesh);
  // The mesh and its labels may be the same file.
  files.reads("LABELS", o.labels);
  files.writes("-o", o.outputs, check_curve_name);
  files.writes("--labels-out", o.labels_out, o.labels_out == "-" ? nullptr : check_label_name);
  files.writes("--cut", o.cut, check_mesh_name);
  files.writes("--cut-labels", o.cut_labels, o.cut_labels == "-" ? nullptr : check_label_list_name);
  files.writes("--report", o.report);
  files.check();
}

int run_labels(const LabelsOptions& o, const GlobalOptions& global) {
  check_unit(o.mesh_units);
  check_points(o.written);
  check_files(o);
  MeshAttributes attributes;
  const Stopwatch since_start;
  ReadMesh read = read_and_repair(o.mesh, o.repair, attributes);
  const bool single = read.lists.single_precision;
  const CoordinateFrame frame = with_unit(read.lists.frame(), o.mesh_units);
  std::vector<std::string> warnings = reading_warnings({}, read.lists.polygon_count);
  const auto mesh = OpenedMesh::open(std::move(read.lists));
  const ReadLabels file = read_labels(o.labels, mesh->surface(), read.map.get(), o.property);
  if (!o.labels_out.empty()) {
    const std::size_t faces = mesh->surface().face_count();
    check_label_kind(o.labels_out, are_of_faces(o, file.labels.size(), faces));
  }
  const double load_ms = since_start.ms() - mesh->open_ms();
  LabelNetworkOptions options = o.network;
  options.budget = budget_of(o, since_start.ms());
  options.free_junctions = o.junctions == "free";
  options.sliding_ends = o.ends == "slide";
  const Stopwatch watch;
  LabelNetwork network;
  try {
    network = smooth_labels(mesh, file.labels, options, progress_bar(global.quiet));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kBadCurve) throw;
    throw Error(ErrorCode::kBadFile,
                o.labels + ": " + error.what() + weld_hint(mesh->mesh(), kRepairOption));
  }
  const double ms = watch.ms();
  clear_progress_bar();
  if (network.cancelled) {
    std::fprintf(stderr, "talweg: cancelled; nothing was written.\n");
    return kCancelled;
  }
  const std::vector<std::string> held = warnings_of(network, file.names);
  warnings.insert(warnings.end(), read.changes.begin(), read.changes.end());
  warnings.insert(warnings.end(), held.begin(), held.end());
  LabelOutput returned;
  if (!o.labels_out.empty()) {
    returned = new_labels(o, network, mesh->surface(), read.map.get(), file, warnings);
  }
  network.cut.lists.single_precision = single;
  network.cut.lists.space = frame.space;
  network.total.time_ms.load = load_ms;
  network.total.time_ms.total += load_ms;
  write(o, network, mesh->mesh(), read.map.get(), attributes, warnings, file, returned, frame);
  if (!global.quiet) {
    std::fputs(summary_of(network, ms).c_str(), text_stream());
    for (const std::string& warning : warnings) {
      std::fprintf(text_stream(), "%s\n", warning.c_str());
    }
  }
  if (!options.budget.any() || network.total.termination != Outcome::kLimit) return kDone;
  if (!global.quiet) {
    std::fputs("talweg: the budget was used up; the best result was written all the same.\n",
               stderr);
  }
  return kNotConverged;
}

}  // namespace

Command add_labels(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<LabelsOptions>();
  CLI::App* command = app.add_subcommand(
      "labels",
      "Smooth all borders of a segmentation together: none crosses another, no region is lost or "
      "torn apart");
  command->add_option("mesh", o->mesh, mesh_help())->required();
  command
      ->add_option(
          "labels", o->labels,
          "One whole number per face or per vertex (text, .csv, .npy); or a PLY, VTK or VTP file "
          "with such a property, which may be the mesh itself; or FreeSurfer's .annot, .label or "
          ".dpv; or GIFTI's .label.gii")
      ->required();
  command->add_option("--labels-property", o->property,
                      "The property of LABELS to read (default: the first of label, labels, "
                      "segment, region, class, scalar_label)");
  command->add_option("--tau", o->network.tau, "Higher values keep closer to the labels' borders")
      ->capture_default_str();
  command->add_option(
      "--slack", o->network.slack,
      "How exact the labels are, in mesh units (default: chosen for each border as smooth does)");
  command->add_option(
      "--max-deviation", o->network.max_deviation,
      "The largest deviation of each smoothed border from the given one, either way, mesh units");
  command
      ->add_option(
          "--junctions", o->junctions,
          "fixed: junctions stay where the labels have them; free: each moves to the place where "
          "its borders balance, at most by the slack or by 0.75 of --max-deviation")
      ->check(CLI::IsMember({"fixed", "free"}))
      ->capture_default_str();
  command
      ->add_option(
          "--ends", o->ends,
          "stay: ends on the mesh's boundary stay; slide: each moves along the boundary to "
          "the place where its border meets the boundary at a right angle, at most as far "
          "as a junction may move")
      ->check(CLI::IsMember({"stay", "slide"}))
      ->capture_default_str();
  command->add_option("--budget", o->budget,
                      "Seconds that the run may take, reading included; then the best result so "
                      "far is written");
  command
      ->add_option("--budget-work", o->budget_work,
                   "A budget in counted steps of about 0.1 microseconds instead of seconds: the "
                   "same result on every machine")
      ->type_name("INT");
  command->add_option("-o,--output", o->outputs,
                      "The borders as curves; the ending chooses the format; may be given several "
                      "times");
  CLI::Option* labels_out = command->add_option(
      "--labels-out", o->labels_out,
      "New labels of the mesh's faces (for each face the label that covers most of it) or of its "
      "vertices; the ending chooses the format: .txt .csv .npy .dpv .annot .label .gii .ply .vtk "
      ".vtp");
  command
      ->add_option("--labels-per", o->labels_per,
                   "Whether the new labels are labels of vertices or of faces (default: as in "
                   "LABELS)")
      ->check(CLI::IsMember({"vertex", "face"}))
      ->needs(labels_out);
  CLI::Option* cut = command->add_option(
      "--cut", o->cut,
      "The mesh with the borders as edges: .ply (with the faces' labels), .obj, .off");
  command
      ->add_option("--cut-labels", o->cut_labels,
                   "The exact labels of the faces of the mesh that --cut writes")
      ->needs(cut);
  command->add_option("--report", o->report, "Steps and measures, as JSON");
  add_repair_option(*command, o->repair);
  add_unit_option(*command, o->mesh_units);
  add_point_options(*command, o->written);
  return [o, &global] { return run_labels(*o, global); };
}

}  // namespace talweg::driver

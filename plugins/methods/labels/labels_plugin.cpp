// talweg.labels: all borders of a segmentation, smoothed together.
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "methods/budget_choice.hpp"
#include "methods/made_meshes.hpp"
#include "methods/mesh_workspace.hpp"
#include "methods/plugins.hpp"
#include "methods/point_fields.hpp"
#include "methods/results.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/labels/label_report.hpp"
#include "talweg/core/labels/returned_labels.hpp"
#include "talweg/core/version.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kJunctions[] = {"fixed", "free"};
constexpr const char* kJunctionLabels[] = {"Where the labels have them",
                                           "Free: moved to where the borders balance"};
constexpr const char* kEnds[] = {"stay", "slide"};
constexpr const char* kEndLabels[] = {"Stay", "Slide along the boundary"};

class Labels : public MakesMeshes<MeshWorkspace> {
 public:
  using MakesMeshes::MakesMeshes;

  static talweg_plugin about() {
    talweg_plugin about = {};
    about.id = "talweg.labels";
    about.label = "Smooth label borders";
    about.version = version();
    about.doc =
        "Smooths all borders of a segmentation together: none crosses another, no region is lost "
        "or torn apart. Labels are whole numbers, one for each triangle or one for each vertex.";
    return about;
  }
  static std::vector<talweg_parameter> parameters() {
    using plugin::array, plugin::choice, plugin::number;
    constexpr std::uint32_t kRun = TALWEG_STAGE_RUN;
    std::vector<talweg_parameter> own = {
        array(
            TALWEG_TRIANGLE_FIELD, "triangle_labels", "Labels of triangles", "",
            "A whole number for each triangle. Give labels of triangles or of vertices, not both.",
            TALWEG_STAGE_CURVES),
        array(TALWEG_FIELD, "vertex_labels", "Labels of vertices", "",
              "A whole number for each vertex.", TALWEG_STAGE_CURVES),
        number("tau", "Tau", "", 1, {0, HUGE_VAL, 0, 16},
               "Higher values keep closer to the borders."),
        number("slack", "Slack", "mesh units", 0, {0, HUGE_VAL, 0, 10},
               "How exact the labels are. By default chosen for each border as in talweg.smooth.",
               kRun, TALWEG_OPTIONAL),
        number("max_deviation", "Largest deviation", "mesh units", 0, {0, HUGE_VAL, 0, 10},
               "The largest deviation of each smoothed border from the given one, either way. By "
               "default no bound.",
               kRun, TALWEG_OPTIONAL | TALWEG_OPEN_MINIMUM),
        choice("junctions", "Junctions", "fixed", kJunctions, kJunctionLabels,
               "free: each junction moves to the place where its borders balance, at most by the "
               "slack or by 0.75 of the largest deviation."),
        choice("ends", "Ends on the boundary", "stay", kEnds, kEndLabels,
               "slide: each end moves along the boundary to the place where its border meets the "
               "boundary at a right angle, at most as far as a junction may move.")};
    for (const talweg_parameter& parameter : budget_parameters()) own.push_back(parameter);
    return with_repair(own);
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {output(TALWEG_OUTPUT_CURVES, "borders", "Borders", "",
                   "The smoothed borders. The entries borders.N.left and .right of the report have "
                   "the labels on both sides."),
            output(TALWEG_OUTPUT_POINT_FIELD, "curvature", "Geodesic curvature", "radians",
                   "The turning angle at each point; 0 at the ends."),
            output(TALWEG_OUTPUT_TRIANGLE_FIELD, "labels", "New labels", "",
                   "The label that covers the largest part of each triangle."),
            output(TALWEG_OUTPUT_MESH, "mesh", "Cut mesh", "",
                   "The mesh with the borders as edges; attribute label: the exact labels of its "
                   "triangles (talweg_meshes.h)."),
            output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                   "Steps and measures, for each border and region and in total.")};
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    made_.clear();
    const Given given = labels_of(parameters);
    const auto network = std::make_shared<LabelNetwork>(cancellable([&] {
      return smooth_labels(opened_mesh(), given.on_mesh, options_of(parameters), progress());
    }));
    if (network->cancelled) throw plugin::Services::cancelled();
    std::vector<std::string> warnings = host_mesh().changes();
    for (std::string& held : warnings_of(*network)) warnings.push_back(std::move(held));
    std::vector<double> labels;
    if (outputs.wants_fields()) labels = new_labels(*network, given, warnings);
    for (const std::string& warning : warnings) services().log(TALWEG_LOG_WARNING, warning);
    std::vector<SurfaceCurve> curves;
    for (const SmoothedBorder& border : network->borders) curves.push_back(border.border.curve);
    const auto each = curve_entries_of(*network);
    const auto fields = [&](std::size_t c) -> std::vector<PointField> {
      return {curvature_field(mesh(), curves[c])};
    };
    give_curves(outputs, host_mesh(), curves, fields, [&](std::int64_t curve) {
      return curve < 0 ? entries_of(*network, warnings) : each[static_cast<std::size_t>(curve)];
    });
    if (outputs.wants_fields()) give(outputs, "labels", "", labels);
    if (outputs.wants_meshes()) give_cut(outputs, network);
  }

 private:
  struct Given {
    std::vector<std::int64_t> on_mesh;  // per vertex or face of the opened mesh
    std::vector<double> came_in;
    bool by_triangle = true;
  };

  static LabelNetworkOptions options_of(const plugin::Parameters& parameters) {
    LabelNetworkOptions options;
    options.tau = parameters.number("tau");
    options.slack = parameters.optional("slack");
    options.max_deviation = parameters.optional("max_deviation");
    options.free_junctions = parameters.choice("junctions") == "free";
    options.sliding_ends = parameters.choice("ends") == "slide";
    options.budget = budget_of(parameters);
    return options;
  }

  [[nodiscard]] Given labels_of(const plugin::Parameters& parameters) const {
    const std::vector<double>& triangles = parameters.field("triangle_labels");
    const std::vector<double>& vertices = parameters.field("vertex_labels");
    if (triangles.empty() == vertices.empty()) {
      throw plugin::Failure(
          TALWEG_BAD_USAGE,
          triangles.empty()
              ? "There are no labels: set triangle_labels or vertex_labels."
              : "Both triangle_labels and vertex_labels are set; set only one of them.");
    }
    Given given;
    given.by_triangle = vertices.empty();
    given.came_in = given.by_triangle ? triangles : vertices;
    const char* const name = given.by_triangle ? "Labels of triangles (triangle_labels)"
                                               : "Labels of vertices (vertex_labels)";
    for (std::size_t k = 0; k < given.came_in.size(); ++k) {
      const double label = given.came_in[k];
      if (label == std::floor(label) && std::abs(label) < 9007199254740992.0) continue;
      throw plugin::Failure(TALWEG_BAD_USAGE,
                            fmt::format("{} must be whole numbers, not {} at {}.", name, label, k));
    }
    const std::vector<double> on_mesh = given.by_triangle
                                            ? host_mesh().per_face_from_host(given.came_in, name)
                                            : host_mesh().per_vertex_from_host(given.came_in, name);
    for (const double label : on_mesh) given.on_mesh.push_back(static_cast<std::int64_t>(label));
    return given;
  }

  /// The new labels, one per triangle of the host's mesh. A triangle that the repair dropped has
  /// its old label, or, if labels are per vertex, the old label of its first corner. Adds a warning
  /// on labels that would be lost.
  [[nodiscard]] std::vector<double> new_labels(const LabelNetwork& network, const Given& given,
                                               std::vector<std::string>& warnings) const {
    const RepairMap* map = host_mesh().map();
    const std::vector<std::int64_t> came_in(given.came_in.begin(), given.came_in.end());
    std::vector<std::int64_t> labels = network.face_labels;
    if (map != nullptr) {
      const MeshLists lists = given.by_triangle ? MeshLists{} : host_mesh().lists();
      labels = map->to_file_faces(labels, [&](std::size_t f) {
        return came_in[given.by_triangle ? f : lists.triangles[f][0]];
      });
    }
    const std::vector<LostLabel> lost = give_back(came_in, network.face_labels, labels);
    if (!lost.empty()) {
      warnings.push_back(fmt::format("{}.", note_on_lost(lost, given.by_triangle, true)));
    }
    return {labels.begin(), labels.end()};
  }

  void give_cut(const plugin::Outputs& outputs, const std::shared_ptr<LabelNetwork>& network) {
    MeshParts whole = taken_apart(network->cut, {});
    give_parts(outputs, std::move(whole.parts), {network, &network->cut});
    made_.last().own = [network](const plugin::TakeAttribute& take) {
      const AttributeColumn column = label_column(network->cut_labels);
      const bool whole_number = column.type == NumberType::kInt32;
      give_per_triangle("label", column.values, whole_number ? TALWEG_INT32 : TALWEG_FLOAT64, take);
    };
  }
};

}  // namespace

const talweg_plugin* labels_plugin() { return plugin::Adapter<Labels>::plugin(); }

}  // namespace talweg::plugins

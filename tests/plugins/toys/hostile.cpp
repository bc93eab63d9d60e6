// toy.hostile: a plugin that returns invalid results, or never returns. Hosts must refuse the
// results and go on.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "talweg/plugin/talweg_plugin.hpp"

#ifndef TOY_ID
#define TOY_ID "toy.hostile"
#endif
#ifndef TOY_FAULT
#define TOY_FAULT "none"
#endif

namespace talweg::test {
namespace {

using plugin::view;

/// A valid curve in one triangle: through a corner, a point on an edge and a point inside.
struct Given {
  std::vector<std::uint32_t> vertices = {0, TALWEG_NO_VERTEX, TALWEG_NO_VERTEX};
  std::vector<std::uint32_t> faces = {0, 0, 0};
  std::vector<double> weights = {1, 0, 0, 0.5, 0.5, 0, 0.25, 0.25, 0.5};
  std::vector<double> positions = {0, 0, 0, 0.5, 0, 0, 0.25, 0.5, 0};
  std::vector<double> field = {1, 2, 3};
  std::uint32_t mesh_corner = 2;

  void spoil(const std::string& fault) {
    if (fault == "nan_position") positions[4] = std::nan("");
    if (fault == "infinite_position") positions[8] = HUGE_VAL;
    if (fault == "face_out_of_range") faces[1] = 1'000'000'000;
    if (fault == "vertex_out_of_range") vertices[2] = 77'777'777;
    if (fault == "nan_weights") weights[3] = std::nan("");
    if (fault == "large_weights") weights[6] = 3;
    if (fault == "few_positions") positions.resize(6);
    if (fault == "few_weights") weights.resize(3);
    if (fault == "no_points") vertices = faces = {}, weights = positions = {};
    if (fault == "short_field") field.resize(2);
    if (fault == "mesh_corner") mesh_corner = 99;
  }
};

class Hostile {
 public:
  explicit Hostile(const plugin::Services& services) : services_(services) {}

  static talweg_plugin about() {
    talweg_plugin plugin = {};
    plugin.flags = TALWEG_TAKES_CURVES;
    plugin.id = TOY_ID;
    plugin.label = "Gives nonsense";
    plugin.version = "1";
    plugin.doc = "Gives what no plugin should give.";
    return plugin;
  }
  static std::vector<talweg_parameter> parameters() {
    static const std::vector<const char*> faults = {
        "none",        "nan_position",  "infinite_position", "face_out_of_range",
        "few_weights", "nan_weights",   "large_weights",     "vertex_out_of_range",
        "no_points",   "few_positions", "null_data",         "real_faces",
        "short_field", "null_name",     "null_fields",       "curve_number",
        "null_key",    "null_text",     "no_value",          "short_mesh_field",
        "mesh_corner", "goes_on",       "never_runs",        "never_opens"};
    talweg_parameter fault = {};
    fault.size = sizeof fault;
    fault.type = TALWEG_CHOICE;
    fault.stage = TALWEG_STAGE_MESH;
    fault.id = "fault";
    fault.label = "Fault";
    fault.unit = "";
    fault.doc = "Which nonsense.";
    fault.default_choice = TOY_FAULT;
    fault.choice_count = static_cast<std::uint32_t>(faults.size());
    fault.choices = faults.data();
    fault.choice_labels = faults.data();
    return {fault};
  }
  static std::vector<talweg_output> outputs() {
    return {plugin::output(TALWEG_OUTPUT_CURVES, "curves", "Curves", "", "One."),
            plugin::output(TALWEG_OUTPUT_VERTEX_FIELD, "field", "Field", "", "One."),
            plugin::output(TALWEG_OUTPUT_MESH, "mesh", "Mesh", "", "One."),
            plugin::output(TALWEG_OUTPUT_REPORT, "report", "Report", "", "One line.")};
  }

  void set_mesh(const talweg_mesh& mesh, const plugin::Parameters& parameters) {
    vertex_count_ = static_cast<std::size_t>(mesh.positions.rows);
    if (parameters.choice("fault") == "never_opens") never_return();
  }
  void share_mesh(const Hostile& other) { vertex_count_ = other.vertex_count_; }
  void set_curves(std::span<const talweg_curve* const> /*curves*/) {}

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    const std::string fault(parameters.choice("fault"));
    if (fault == "never_runs") never_return();
    try {
      give_curve(fault == "goes_on" ? "nan_position" : fault, outputs);
    } catch (const plugin::Failure&) {
      if (fault != "goes_on") throw;
    }
    give_entry(fault, outputs);
    std::vector<double> values(vertex_count_, 1.5);
    if (fault == "short_mesh_field") values.pop_back();
    outputs.field({0, "field", "", view(values.data(), values.size())});
    give_mesh(fault, outputs);
  }

 private:
  [[noreturn]] void never_return() const {
    (void)services_.go_on("endless", 0.5);
    while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
  }

  static void give_curve(const std::string& fault, const plugin::Outputs& outputs) {
    Given given;
    given.spoil(fault);
    const talweg_field field = {sizeof field, fault == "null_name" ? nullptr : "toy", "",
                                view(given.field.data(), given.field.size())};
    const talweg_field* fields[] = {&field};
    talweg_curve curve = {};
    curve.vertices = view(given.vertices.data(), given.vertices.size());
    curve.faces = view(given.faces.data(), given.faces.size());
    curve.barycentrics = view(given.weights.data(), given.weights.size() / 3, 3);
    curve.positions = view(given.positions.data(), given.positions.size() / 3, 3);
    if (fault == "null_data") curve.positions.data = nullptr;
    if (fault == "real_faces") curve.faces = view(given.positions.data(), 3);
    curve.field_count = 1;
    curve.fields = fault == "null_fields" ? nullptr : fields;
    outputs.curve(curve);
  }

  static void give_entry(const std::string& fault, const plugin::Outputs& outputs) {
    const double number = 1;
    const char* text = fault == "null_text" ? nullptr : "well";
    talweg_report_entry entry = {sizeof entry, TALWEG_VALUE_NUMBER, -1, "value", 0, 1, &number,
                                 &text};
    if (fault == "null_text") entry.type = TALWEG_VALUE_TEXT;
    if (fault == "null_key") entry.key = nullptr;
    if (fault == "curve_number") entry.curve = 1'000'000'000'000;
    if (fault == "no_value") entry.count = 0;
    outputs.entry(entry);
  }

  static void give_mesh(const std::string& fault, const plugin::Outputs& outputs) {
    Given given;
    given.spoil(fault);
    const std::uint32_t triangle[] = {0, 1, given.mesh_corner};
    talweg_mesh mesh = {};
    mesh.positions = view(given.positions.data(), 3, 3);
    mesh.triangles = view(triangle, 1, 3);
    outputs.mesh(mesh);
  }

  const plugin::Services& services_;
  std::size_t vertex_count_ = 0;
};

}  // namespace
}  // namespace talweg::test

TALWEG_PLUGIN_MODULE(talweg::test::Hostile)

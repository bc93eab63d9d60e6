// A plugin: how high the vertices of a mesh lie above a level, along one of the axes.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <talweg/plugin/talweg_plugin.hpp>

namespace {

namespace tp = talweg::plugin;

constexpr const char* kAxes[] = {"x", "y", "z"};
constexpr const char* kAxisLabels[] = {"Along x", "Along y", "Along z"};

class Height {
 public:
  explicit Height(const tp::Services& services) : services_(&services) {}

  // The description of the plugin, from which a host makes its panel, its options and its help.
  static talweg_plugin about() {
    talweg_plugin about = {};
    about.id = "example.height";
    about.label = "Height";
    about.version = "1.0";
    about.doc = "How high the vertices of a mesh lie above a level.";
    return about;
  }
  static std::vector<talweg_parameter> parameters() {
    return {tp::choice("axis", "Axis", "z", kAxes, kAxisLabels, "Which way is up."),
            tp::number("level", "Level", "mesh units", 0, {-HUGE_VAL, HUGE_VAL, -10, 10},
                       "Where the height is 0.")};
  }
  static std::vector<talweg_output> outputs() {
    return {tp::output(TALWEG_OUTPUT_VERTEX_FIELD, "height", "Height", "mesh units",
                       "Negative below the level."),
            tp::output(TALWEG_OUTPUT_REPORT, "report", "Report", "", "The largest height.")};
  }

  // Copies what it needs: the host's arrays are there until this returns.
  void set_mesh(const talweg_mesh& mesh) {
    std::vector<double> xyz = tp::numbers_of(mesh.positions, 3, "The mesh's positions");
    if (xyz.empty()) throw tp::Failure(TALWEG_BAD_MESH, "The mesh has no vertices.");
    xyz_ = std::move(xyz);
  }

  // Computes all, then gives it. What it throws becomes a status and a sentence.
  void run(const tp::Parameters& parameters, const tp::Outputs& outputs) {
    const std::string& name = parameters.choice("axis");
    const std::size_t axis = name == "x" ? 0 : name == "y" ? 1 : 2;
    std::vector<double> height;
    for (std::size_t k = axis; k < xyz_.size(); k += 3) {
      if (k % 30000 < 3 && !services_->go_on("height", double(k) / double(xyz_.size()))) {
        throw tp::Services::cancelled();
      }
      height.push_back(xyz_[k] - parameters.number("level"));
    }
    outputs.report(-1, "height_max", *std::max_element(height.begin(), height.end()));
    outputs.field(
        {sizeof(talweg_field), "height", "mesh units", tp::view(height.data(), height.size())});
  }

 private:
  const tp::Services* services_;
  std::vector<double> xyz_;
};

}  // namespace

TALWEG_PLUGIN_MODULE(Height)

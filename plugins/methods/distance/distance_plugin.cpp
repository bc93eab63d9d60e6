// talweg.distance: the distance to curves and the potential over it, per vertex.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "methods/plugins.hpp"
#include "methods/point_fields.hpp"
#include "methods/results.hpp"
#include "methods/smoother_workspace.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/lifting/potential.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kPotentials[] = {"corridor", "paper"};
constexpr const char* kPotentialLabels[] = {"Corridor: exact distance, flat within the slack",
                                            "The paper's: heat method, equations 4 to 6"};

/// The largest finite distance in each component.
std::vector<double> largest_of(const Components& components, const std::vector<double>& distance) {
  std::vector<double> largest(components.count, 0.0);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    double& most = largest[components.of_vertex[v]];
    if (std::isfinite(distance[v])) most = std::max(most, distance[v]);
  }
  return largest;
}

class Distance : public SmootherWorkspace {
 public:
  using SmootherWorkspace::SmootherWorkspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.distance", "Distance to curves",
        "The distance along the surface to the nearest curve, and the potential that talweg.smooth "
        "makes of this distance, at every vertex of the mesh.");
  }
  static std::vector<talweg_parameter> parameters() {
    using plugin::choice, plugin::number;
    return with_repair(
        {choice("potential", "Potential", "corridor", kPotentials, kPotentialLabels,
                "The distance and the potential to compute, as in talweg.smooth.",
                TALWEG_STAGE_CURVES),
         number("tau", "Tau", "", 1, {0, HUGE_VAL, 0, 16}, "Steepness of the potential."),
         number("slack", "Slack", "mesh units", 0, {0, HUGE_VAL, 0, 10},
                "The distance within which the corridor is flat. By default as in talweg.smooth.",
                TALWEG_STAGE_RUN, TALWEG_OPTIONAL),
         number("heat_time", "Heat time", "squared mean edge lengths", 10, {1e-3, 1e6, 1, 100},
                "Smoothing of the paper's distance.", TALWEG_STAGE_CURVES,
                TALWEG_ADVANCED | TALWEG_LOGARITHMIC),
         plugin::integer("threads", "Threads", 2, {1, 1024, 1, 16},
                         "Threads at most; never changes a result.", TALWEG_STAGE_RUN,
                         TALWEG_ADVANCED)});
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {output(TALWEG_OUTPUT_VERTEX_FIELD, "distance", "Distance", "mesh units",
                   "Infinite where no curve can be reached."),
            output(TALWEG_OUTPUT_VERTEX_FIELD, "potential", "Potential", "mesh units",
                   "The height by which the surface is lifted; 0 where no curve can be reached."),
            output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                   "The largest distance and potential, and the slack of each curve.")};
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    solve(parameters);
    const std::vector<double> potential =
        is_corridor(parameters) ? corridor_potential(parameters) : paper_potential(parameters);
    const auto most = [](const std::vector<double>& values) {
      double largest = 0;
      for (const double value : values) {
        if (std::isfinite(value)) largest = std::max(largest, value);
      }
      return largest;
    };
    outputs.report(-1, "distance_max", most(distance_));
    outputs.report(-1, "potential_max", most(potential));
    give(outputs, -1, {{"warnings", reading_warnings()}});
    for (std::size_t c = 0; c < slack_.size(); ++c) {
      outputs.report(static_cast<std::int64_t>(c), "slack",
                     parameters.optional("slack").value_or(slack_[c]));
    }
    give(outputs, "distance", "mesh units", host_mesh().per_vertex_to_host(distance_));
    give(outputs, "potential", "mesh units", host_mesh().per_vertex_to_host(potential));
  }

 private:
  static bool is_corridor(const plugin::Parameters& parameters) {
    return parameters.choice("potential") == "corridor";
  }

  /// Computes the distance with the smoother itself, so that smoothing has the same distance.
  void solve(const plugin::Parameters& parameters) {
    const std::uint64_t changes = parameters.changes_of(TALWEG_STAGE_CURVES);
    if (has_smoother() && drawings() == drawings_ && changes == changes_ && !distance_.empty())
      return;
    distance_.clear();
    CurveOptions options;
    options.method = is_corridor(parameters) ? Method::kCorridor : Method::kPaper;
    options.heat_time = parameters.number("heat_time");
    options.threads = static_cast<unsigned>(parameters.number("threads"));
    if (!smoother().set_curves(drawing().curves, options, progress())) {
      throw plugin::Services::cancelled();
    }
    slack_ = smoother().slack();
    if (is_corridor(parameters)) {
      nearest_ = nearest_field(mesh().surface(), drawing().curves, services());
      for (const NearestOnCurve& nearest : nearest_) distance_.push_back(nearest.distance);
    } else {
      nearest_.clear();
      distance_.assign(smoother().distance().begin(), smoother().distance().end());
    }
    drawings_ = drawings();
    changes_ = changes;
  }

  [[nodiscard]] std::vector<double> paper_potential(const plugin::Parameters& parameters) const {
    const Components components = components_of(mesh().surface());
    const std::vector<double> largest = largest_of(components, distance_);
    std::vector<double> values;
    for (std::size_t v = 0; v < distance_.size(); ++v) {
      const double length = largest[components.of_vertex[v]];
      values.push_back(length > 0 && std::isfinite(distance_[v])
                           ? Potential({}, parameters.number("tau"), length)(distance_[v])
                           : 0.0);
    }
    return values;
  }

  /// The norm of the corridor's two-component lift at each vertex. The norm does not depend on the
  /// lift's phase.
  [[nodiscard]] std::vector<double> corridor_potential(const plugin::Parameters& parameters) const {
    std::vector<Corridor::Valley> valleys;
    for (std::size_t c = 0; c < drawing().curves.size(); ++c) {
      const SurfaceCurve& curve = drawing().curves[c];
      Corridor::Valley valley;
      valley.slack = parameters.optional("slack").value_or(slack_[c]);
      valley.length = corridor_length(mesh(), curve);
      valleys.push_back(valley);
    }
    PolylineDistance distance(mesh().surface());
    distance.set(drawing().curves);
    const Corridor corridor(distance, parameters.number("tau"), valleys);
    std::vector<double> values;
    for (const NearestOnCurve& nearest : nearest_) {
      const auto lift = corridor.lifted(nearest);
      values.push_back(std::hypot(lift[0], lift[1]));
    }
    return values;
  }

  std::vector<double> distance_, slack_;
  std::vector<NearestOnCurve> nearest_;  // per vertex; only for the corridor
  std::uint64_t drawings_ = 0;
  std::uint64_t changes_ = 0;
};

}  // namespace

const talweg_plugin* distance_plugin() { return plugin::Adapter<Distance>::plugin(); }

}  // namespace talweg::plugins

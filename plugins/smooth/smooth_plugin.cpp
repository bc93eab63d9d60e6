// talweg.smooth: the pipeline, from drawing to smoothed curve.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/point_fields.hpp"
#include "common/results.hpp"
#include "common/workspace.hpp"
#include "smooth_parameters.hpp"
#include "talweg/core/curve_smoother.hpp"
#include "talweg/core/max_deviation.hpp"
#include "talweg/core/version.hpp"

namespace talweg::plugins {
namespace {

class Smooth : public Workspace {
 public:
  using Workspace::Workspace;

  static talweg_plugin about() {
    talweg_plugin about = {};
    about.flags = TALWEG_TAKES_CURVES;
    about.id = "talweg.smooth";
    about.label = "Smooth curves";
    about.version = version();
    about.doc =
        "Smooths drawn curves while they stay close to the drawing. Several curves are smoothed "
        "together and do not cross. Vertices of a drawing must be neighbours; other points are "
        "joined straight over the surface.";
    return about;
  }
  static std::vector<talweg_parameter> parameters() { return smooth_parameters(); }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {
        output(TALWEG_OUTPUT_CURVES, "curves", "Smoothed curves", "",
               "One for each drawn curve, in their order."),
        output(TALWEG_OUTPUT_POINT_FIELD, "deviation", "Deviation", "mesh units",
               "Distance along the surface to the drawn curve."),
        output(TALWEG_OUTPUT_POINT_FIELD, "curvature", "Geodesic curvature", "radians",
               "By how much the curve turns at the point; 0 at the ends."),
        output(TALWEG_OUTPUT_VERTEX_FIELD, "distance", "Distance to the drawing", "mesh units",
               "The distance that the potential is made of; infinite where no curve is reached."),
        output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
               "What was done and measured, of each curve and in total."),
    };
  }

  void set_mesh(const talweg_mesh& mesh) {
    Workspace::set_mesh(mesh);
    smoother_.reset();
  }
  void share_mesh(const Smooth& other) {
    Workspace::share_mesh(other);
    smoother_.reset();
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    const CurveOptions curve_options = curve_options_of(parameters);
    const std::optional<std::size_t> dragged = dragged_curve(parameters);
    if (!dragged) solve(parameters, curve_options);
    SmoothingOptions options = smoothing_options_of(parameters);
    if (!parameters.field("slack_field").empty()) {
      for (const SurfaceCurve& curve : smoother_->drawn()) {
        options.slack_at.push_back(
            slack_along(mesh().surface(), curve, parameters.field("slack_field")));
      }
    }
    options.progress = progress();
    SmoothingResult result = dragged ? drag(*dragged, parameters, options)
                                     : smooth(parameters.optional("max_deviation"), options);
    if (result.total.termination == to_string(Termination::kCancelled)) {
      throw plugin::Services::cancelled();
    }
    add_warnings(result);
    give_all(outputs, result);
  }

 private:
  SmoothingResult smooth(std::optional<double> bound, const SmoothingOptions& options) {
    SmoothingResult result =
        bound ? smooth_within(*smoother_, *bound, options) : smoother_->smooth(options);
    found_tau_ = result.total.tau;
    found_slack_ = result.total.slack;
    return result;
  }

  /// With tau and slack as they were found for the bound, if there is one.
  SmoothingResult drag(std::size_t curve, const plugin::Parameters& parameters,
                       SmoothingOptions options) {
    if (parameters.optional("max_deviation")) {
      options.tau = found_tau_;
      options.slack = found_slack_;
    }
    return smoother_->drag(curve, drawing().curves[curve], options);
  }

  /// The one curve that is not as it was in the last run without preview; none where that says
  /// nothing about this run.
  [[nodiscard]] std::optional<std::size_t> dragged_curve(
      const plugin::Parameters& parameters) const {
    if (!parameters.flag("preview") || parameters.choice("potential") != "corridor") return {};
    if (!smoother_ || !solved_ || changes_of(parameters) != changes_) return {};
    const auto drawn = smoother_->drawn();
    const std::vector<SurfaceCurve>& now = drawing().curves;
    if (now.size() != drawn.size()) return {};
    std::vector<std::size_t> changed;
    for (std::size_t c = 0; c < now.size(); ++c) {
      if (now[c].closed != drawn[c].closed || now[c].points != drawn[c].points) {
        changed.push_back(c);
      }
    }
    if (changed.size() > 1) return {};
    return changed.empty() ? 0 : changed.front();
  }

  [[nodiscard]] std::vector<SurfacePoint> pins(const plugin::Parameters& parameters) const {
    std::vector<SurfacePoint> pins = drawing().pins;
    for (const std::uint32_t v : parameters.vertices("pin")) {
      pins.push_back(SurfacePoint::at_vertex(mesh().surface(), VertexId{v}));
    }
    return pins;
  }

  static std::uint64_t changes_of(const plugin::Parameters& parameters) {
    return parameters.changes_of(TALWEG_STAGE_CURVES) - parameters.changes("pin");
  }

  /// Sets the curves where anything that they depend on has changed.
  void solve(const plugin::Parameters& parameters, CurveOptions options) {
    options.pins = pins(parameters);
    const std::uint64_t changes = changes_of(parameters);
    if (solved_ && smoother_ && drawings() == drawings_ && changes == changes_) {
      if (options.pins == pins_) return;
      if (options.method == Method::kCorridor) {
        smoother_->set_pins(options.pins);
        pins_ = options.pins;
        return;
      }
    }
    solved_ = false;
    if (!smoother_) smoother_ = std::make_unique<CurveSmoother>(opened_mesh());
    if (!set_curves_in(parameters.field("distance"), options)) throw plugin::Services::cancelled();
    solved_ = true;
    drawings_ = drawings();
    changes_ = changes;
    pins_ = options.pins;
  }
  bool set_curves_in(const std::vector<double>& distance, const CurveOptions& options) {
    if (!services().go_on("solve", 0)) return false;
    if (distance.empty()) return smoother_->set_curves(drawing().curves, options, progress());
    return smoother_->set_curves(drawing().curves, distance, options);
  }

  void add_warnings(SmoothingResult& result) const {
    if (const std::string moved = snap_warning(drawing()); !moved.empty()) {
      for (SmoothingReport& report : result.reports) report.warnings.push_back(moved);
      result.total.warnings.push_back(moved);
    }
    for (const std::string& warning : result.total.warnings) {
      services().log(TALWEG_LOG_WARNING, warning);
    }
  }

  void give_all(const plugin::Outputs& outputs, const SmoothingResult& result) {
    std::vector<PlacedCurve> placed;
    std::vector<std::vector<PointField>> fields(result.curves.size());
    for (std::size_t c = 0; outputs.wants_curves() && c < result.curves.size(); ++c) {
      placed.push_back(place(mesh(), result.curves[c], c));
      if (!outputs.wants_point_fields()) continue;
      fields[c] = {deviation_field(mesh(), drawing().curves[c], result.curves[c]),
                   curvature_field(mesh(), result.curves[c])};
    }
    std::vector<double> distance;
    if (outputs.wants_fields()) distance = distance_field();
    if (outputs.wants_report()) give(outputs, -1, entries_of(result.total));
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
      if (outputs.wants_curves()) give(outputs, placed[c], fields[c]);
      if (outputs.wants_report()) {
        give(outputs, static_cast<std::int64_t>(c), entries_of(result.reports[c]));
      }
    }
    if (outputs.wants_fields()) give(outputs, "distance", "mesh units", distance);
  }

  [[nodiscard]] std::vector<double> distance_field() const {
    if (!smoother_->distance().empty()) {
      return {smoother_->distance().begin(), smoother_->distance().end()};
    }
    return exact_distance_field(mesh().surface(), drawing().curves, services());
  }

  std::unique_ptr<CurveSmoother> smoother_;  // made when first needed
  bool solved_ = false;
  double found_tau_ = 0, found_slack_ = 0;  // in the last run without preview
  std::uint64_t drawings_ = 0;
  std::uint64_t changes_ = 0;
  std::vector<SurfacePoint> pins_;
};

}  // namespace
}  // namespace talweg::plugins

TALWEG_PLUGIN_MODULE(talweg::plugins::Smooth)

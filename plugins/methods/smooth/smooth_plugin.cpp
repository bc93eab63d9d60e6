// talweg.smooth: the pipeline, from drawing to smoothed curve.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/plugins.hpp"
#include "methods/point_fields.hpp"
#include "methods/results.hpp"
#include "methods/ridge_choice.hpp"
#include "methods/smoother_workspace.hpp"
#include "smooth_parameters.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::plugins {
namespace {

class Smooth : public SmootherWorkspace {
 public:
  using SmootherWorkspace::SmootherWorkspace;

  static talweg_plugin about() {
    talweg_plugin about = about_curves(
        "talweg.smooth", "Smooth curves",
        "Smooths drawn curves while they stay close to the drawing. Several curves are smoothed "
        "together and do not cross. Vertices of a drawing must be neighbours; other points are "
        "joined straight over the surface.");
    about.get_extension = extension;
    return about;
  }
  static const void* extension(const char* id) {
    const bool known = id != nullptr && std::string_view(id) == TALWEG_WAY_POINTS;
    return known ? way_points_extension() : nullptr;
  }
  static std::vector<talweg_parameter> parameters() { return with_repair(smooth_parameters()); }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {
        output(TALWEG_OUTPUT_CURVES, "curves", "Smoothed curves", "",
               "One for each drawn curve, in their order."),
        output(TALWEG_OUTPUT_POINT_FIELD, "deviation", "Deviation", "mesh units",
               "Distance along the surface to the drawn curve."),
        output(TALWEG_OUTPUT_POINT_FIELD, "curvature", "Geodesic curvature", "radians",
               "The turning angle at each point; 0 at the ends."),
        output(
            TALWEG_OUTPUT_VERTEX_FIELD, "distance", "Distance to the drawing", "mesh units",
            "The distance that the potential is made of; infinite where no curve is reached. Far "
            "from the drawing on large meshes about a per cent off."),
        output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
               "Steps and measures, for each curve and in total."),
    };
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    CurveOptions curve_options = curve_options_of(parameters);
    std::optional<ExtendedCurves> extended;
    if (border_ends(parameters.choice("border")) == BorderEnds::kSnap)
      extended = ExtendedCurves::kStrokes;
    finish_ends(curve_ends(parameters.choice("ends")), extended);
    const PointOptions reading =
        point_options(parameters, host_mesh().vertices_from_host(parameters.vertices("exact")));
    curve_options.corners = host_mesh().vertices_from_host(parameters.vertices("corner"));
    points_ = marked_points(drawing(), reading);
    snap_to_ridges(parameters, curve_options.corners);
    free_ = only_way_points(curves(), points_);
    curve_options.way_points = points_.way_points;
    curve_options.painted = points_.painted;
    const std::optional<std::size_t> dragged = dragged_curve(parameters);
    if (!dragged) solve(parameters, curve_options);
    const SmoothingOptions options =
        smoothing_options_of(parameters, mesh().surface(), smoother().drawn(), host_mesh().map());
    SmoothingResult result =
        dragged ? drag(*dragged, parameters, options) : smooth(parameters, options);
    check(result);
    std::vector<std::string> warnings = stroke_warnings(drawing(), reading);
    for (std::string& idle : idle_parameters(parameters, free_))
      warnings.push_back(std::move(idle));
    add_warnings(result, warnings);
    give_all(outputs, result);
  }

 private:
  /// The curves to smooth: the drawing, or the drawing snapped to ridges.
  [[nodiscard]] const std::vector<SurfaceCurve>& curves() const {
    return ridged_.moves.empty() ? drawing().curves : ridged_.curves;
  }
  [[nodiscard]] std::span<const RidgeMoves> moves_of(std::size_t curve) const {
    return std::span(ridged_.moves)
        .subspan(std::min(curve, ridged_.moves.size()), ridged_.moves.empty() ? 0 : 1);
  }

  /// Moves the drawing and its points onto ridges, unless they were moved for the same input
  /// before.
  void snap_to_ridges(const plugin::Parameters& parameters, std::vector<SurfacePoint> fixed) {
    const RidgeOptions options = ridge_options_of(parameters);
    if (options.strength == 0) {
      ridged_ = {};
      ridged_from_ = {};
      return;
    }
    for (const SurfacePoint& pin : pins(parameters)) fixed.push_back(pin);
    RidgedFrom from{drawings(), parameters.changes_of(TALWEG_STAGE_CURVES), std::move(fixed),
                    points_};
    if (ridged_.moves.empty() || !(from == ridged_from_)) {
      ridged_ = cancellable([&] {
        return snapped_to_ridges(mesh(), drawing().curves, from.fixed, points_, options,
                                 progress());
      });
      ridged_from_ = std::move(from);
      solved_ = false;
    }
    points_ = ridged_.points;
  }

  SmoothingResult smooth(const plugin::Parameters& parameters, const SmoothingOptions& options) {
    SmoothingResult result = smooth_by(parameters, smoother(), options, free_, progress());
    found_tau_ = result.total.tau;
    found_slack_ = result.total.slack;
    return result;
  }

  /// Smooths near the dragged curve only. With a largest deviation, tau and slack are those of the
  /// last full run.
  SmoothingResult drag(std::size_t curve, const plugin::Parameters& parameters,
                       SmoothingOptions options) {
    if (parameters.optional("max_deviation") && !free_) {
      options.tau = found_tau_;
      options.slack = found_slack_;
      for (OwnOptions& own : options.per_curve) own.tau.reset();
    }
    return smoother().drag(curve, curves()[curve], options, progress());
  }

  /// The only curve that differs from the smoother's drawing, or 0 if no curve differs; none if
  /// other input has changed.
  std::optional<std::size_t> dragged_curve(const plugin::Parameters& parameters) {
    if (!parameters.flag("preview") || parameters.choice("potential") != "corridor") return {};
    if (!has_smoother() || !solved_ || changes_of(parameters) != changes_) return {};
    const auto drawn = smoother().drawn();
    const std::vector<SurfaceCurve>& now = curves();
    if (now.size() != drawn.size()) return {};
    // Way-points of a dragged curve move with it, which needs a full run.
    if (!points_.way_points.empty() || !solved_points_.way_points.empty()) return {};
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
    for (const SurfacePoint& pin : host_mesh().vertices_from_host(parameters.vertices("pin")))
      pins.push_back(pin);
    return pins;
  }

  static std::uint64_t changes_of(const plugin::Parameters& parameters) {
    return parameters.changes_of(TALWEG_STAGE_CURVES) - parameters.changes("pin");
  }

  /// Sets the curves if anything that they depend on has changed.
  void solve(const plugin::Parameters& parameters, CurveOptions options) {
    options.pins = pins(parameters);
    const std::uint64_t changes = changes_of(parameters);
    const bool same_points = points_ == solved_points_;
    if (solved_ && has_smoother() && drawings() == drawings_ && changes == changes_ &&
        same_points) {
      if (options.pins == pins_) return;
      if (options.method == Method::kCorridor) {
        if (!smoother().set_pins(options.pins, progress())) throw plugin::Services::cancelled();
        pins_ = options.pins;
        return;
      }
    }
    solved_ = false;
    if (!plugins::set_curves(smoother(), curves(), parameters, options, progress(),
                             host_mesh().map())) {
      throw plugin::Services::cancelled();
    }
    solved_ = true;
    solved_points_ = points_;
    drawings_ = drawings();
    changes_ = changes;
    pins_ = options.pins;
  }

  void add_warnings(SmoothingResult& result, const std::vector<std::string>& on_points) const {
    std::vector<std::string> warnings = reading_warnings();
    for (std::size_t c = 0; c < ridged_.moves.size(); ++c) {
      warnings.push_back(ridged_.moves[c].sentence(c));
    }
    warnings.insert(warnings.end(), on_points.begin(), on_points.end());
    const auto add = [&](SmoothingReport& report) {
      drawing().add_to(report.warnings, warnings);
      lead_with(report, drawing().decisive());
    };
    for (SmoothingReport& report : result.reports) add(report);
    add(result.total);
    for (const std::string& warning : result.total.warnings) {
      services().log(TALWEG_LOG_WARNING, warning);
    }
  }

  void give_all(const plugin::Outputs& outputs, const SmoothingResult& result) {
    std::vector<double> distance;
    if (outputs.wants_fields()) distance = distance_field();
    const auto fields = [&](std::size_t c) -> std::vector<PointField> {
      return {deviation_field(mesh(), curves()[c], result.curves[c], services()),
              curvature_field(mesh(), result.curves[c])};
    };
    const std::vector<RidgeMoves>& moves = ridged_.moves;
    plugins::give_curves(outputs, host_mesh(), result.curves, fields, [&](std::int64_t c) {
      const auto k = static_cast<std::size_t>(c);
      std::vector<ReportEntry> entries = entries_of(c < 0 ? result.total : result.reports[k]);
      const auto more = c < 0 ? total_entries(moves) : total_entries(moves_of(k));
      entries.insert(entries.end(), more.begin(), more.end());
      return entries;
    });
    if (outputs.wants_fields()) {
      give(outputs, "distance", "mesh units", host_mesh().per_vertex_to_host(distance));
    }
  }

  std::vector<double> distance_field() {
    if (!smoother().need_distance(progress())) throw plugin::Services::cancelled();
    if (!smoother().distance().empty()) {
      return {smoother().distance().begin(), smoother().distance().end()};
    }
    return quick_distance_field(mesh().surface(), curves(), services());
  }

  /// The input of the ridged drawing.
  struct RidgedFrom {
    std::uint64_t drawings = 0, changes = 0;
    std::vector<SurfacePoint> fixed;
    MarkedPoints points;
    bool operator==(const RidgedFrom&) const = default;
  };

  RidgedDrawing ridged_;  // without moves if ridges do not attract the drawing
  RidgedFrom ridged_from_;
  bool solved_ = false;
  bool free_ = false;                       // whether the drawing has only way-points
  MarkedPoints points_, solved_points_;     // points of this run, and of the set curves
  double found_tau_ = 0, found_slack_ = 0;  // values of the last full run
  std::uint64_t drawings_ = 0;
  std::uint64_t changes_ = 0;
  std::vector<SurfacePoint> pins_;
};

}  // namespace

const talweg_plugin* smooth_plugin() { return plugin::Adapter<Smooth>::plugin(); }

}  // namespace talweg::plugins

// talweg.geodesic: straightens a drawing into a geodesic path or a closed geodesic, without a
// potential that keeps the result near the drawing.
#include <memory>
#include <string>
#include <vector>

#include "methods/plugins.hpp"
#include "methods/point_fields.hpp"
#include "methods/results.hpp"
#include "methods/smoother_workspace.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::plugins {
namespace {

/// The keys of the smoother's report that are meaningful for a geodesic.
constexpr const char* kKeys[] = {
    "version",      "faces",         "vertices",           "closed",          "points_before",
    "points_after", "length_before", "length_after",       "curvature_after", "flips",
    "iterations",   "faces_touched", "trace_fallbacks",    "termination",     "warnings",
    "time_ms.open", "time_ms.solve", "time_ms.straighten", "time_ms.trace",   "peak_memory_mib"};

std::vector<ReportEntry> geodesic_entries(const SmoothingReport& report) {
  std::vector<ReportEntry> chosen;
  for (ReportEntry& entry : entries_of(report)) {
    for (const char* key : kKeys) {
      if (entry.key != key) continue;
      chosen.push_back(std::move(entry));
      break;
    }
  }
  return chosen;
}

class Geodesic : public SmootherWorkspace {
 public:
  using SmootherWorkspace::SmootherWorkspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.geodesic", "Geodesic",
        "Straightens curves until they are locally shortest: geodesic paths between their ends, "
        "closed geodesics. Points need not be neighbours; they are joined straight over the "
        "surface first. Pinned points stay.");
  }
  static std::vector<talweg_parameter> parameters() {
    return with_repair(
        {plugin::boolean("through", "Through every point", false,
                         "Keep all given points, not only the pinned ones."),
         plugin::number("length_floor", "Least length of a loop", "mesh units", 0,
                        {0, HUGE_VAL, 0, 10},
                        "A shorter loop counts as collapsed. By default 3 mean edges of the drawn "
                        "loop.",
                        TALWEG_STAGE_RUN, TALWEG_OPTIONAL | TALWEG_ADVANCED)});
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {output(TALWEG_OUTPUT_CURVES, "curves", "Geodesics", "",
                   "One for each given curve, in their order."),
            output(TALWEG_OUTPUT_POINT_FIELD, "curvature", "Geodesic curvature", "radians",
                   "The turning angle at each point; 0 except at pins and saddles."),
            output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                   "Lengths before and after, of each curve and in total.")};
  }

  void put(const std::vector<CurveInput>& inputs) override {
    SnapOptions options;
    options.connect = true;
    Points given;
    std::vector<SurfaceCurve> joined;
    for (const SnappedCurve& snapped : snapped_on(host_mesh(), inputs, options)) {
      joined.push_back(lines().join(snapped.points, snapped.closed));
      given.all.insert(given.all.end(), snapped.points.begin(), snapped.points.end());
      for (const std::size_t pin : snapped.pins) given.pins.push_back(snapped.points[pin]);
    }
    joined_ = std::move(joined);
    given_ = std::move(given);
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    CurveOptions curve_options;
    curve_options.cap_corners = false;
    curve_options.pins = parameters.flag("through") ? given_.all : given_.pins;
    // Nothing is lifted, so no distance is needed.
    const std::vector<double> flat(mesh().surface().vertex_count(), 0.0);
    if (!smoother().set_curves(joined_, flat, curve_options, progress())) {
      throw plugin::Services::cancelled();
    }
    SmoothingOptions options;
    options.tau = 0;
    options.deviation = DeviationMeasure::kNone;
    options.length_floor = parameters.optional("length_floor");
    SmoothingResult result = smoother().smooth(options, progress());
    check(result);
    add_changes(result);
    const auto fields = [&](std::size_t c) -> std::vector<PointField> {
      return {curvature_field(mesh(), result.curves[c])};
    };
    give_curves(outputs, result, fields, geodesic_entries);
  }

 private:
  struct Points {
    std::vector<SurfacePoint> all, pins;
  };

  std::vector<SurfaceCurve> joined_;
  Points given_;
};

}  // namespace

const talweg_plugin* geodesic_plugin() { return plugin::Adapter<Geodesic>::plugin(); }

}  // namespace talweg::plugins

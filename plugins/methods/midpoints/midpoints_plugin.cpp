// talweg.midpoints: subdivision of curves by geodesic midpoints (Morera et al. 2008).
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "curve_subdivision.hpp"
#include "methods/deviation_choice.hpp"
#include "methods/method_workspace.hpp"
#include "methods/plugins.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::plugins {
namespace {

constexpr double kSegments = 8;  // drawn segments between control points

class Midpoints : public MethodWorkspace {
 public:
  using MethodWorkspace::MethodWorkspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.midpoints", "Subdivision by geodesic midpoints (Morera et al. 2008)",
        "Another method, to compare with talweg.smooth: takes control points from the drawing at "
        "equal distances and subdivides their polygon, with geodesics for straight lines. The "
        "curve does not pass its control points, and nothing bounds how far it goes from the "
        "drawing.");
  }
  static std::vector<talweg_parameter> parameters() {
    return with_repair(
        {plugin::number("spacing", "Spacing of the control points", "mesh units", 0,
                        {0, HUGE_VAL, 0, 10},
                        "Measured along the drawing. By default eight times the mean "
                        "length of the drawing's segments.",
                        TALWEG_STAGE_RUN, TALWEG_OPTIONAL | TALWEG_OPEN_MINIMUM),
         plugin::integer("degree", "Degree", 3, {1, 8, 1, 5},
                         "The degree of the B-spline that the scheme makes in the "
                         "plane."),
         plugin::integer("levels", "Levels", 4, {1, 8, 1, 6},
                         "How often the number of points is doubled."),
         deviation_choice()});
  }

 private:
  Method smooth(const plugin::Parameters& parameters) override {
    const Stopwatch watch;
    Method method{"midpoints", {}, {}};
    const std::vector<SurfaceCurve>& drawn = drawing().curves;
    for (std::size_t c = 0; c < drawn.size(); ++c) {
      go_on("subdivide", static_cast<double>(c) / static_cast<double>(drawn.size()));
      method.curves.push_back(subdivide(drawn[c], parameters));
    }
    method.times.straighten = watch.ms();
    return method;
  }

  MethodCurve subdivide(const SurfaceCurve& drawn, const plugin::Parameters& parameters) {
    const Surface& surface = mesh().surface();
    const auto segments = static_cast<double>(drawn.points.size() - (drawn.closed ? 0 : 1));
    const double spacing = parameters.optional("spacing").value_or(
        kSegments * curve_length(surface, drawn) / segments);
    const int levels = static_cast<int>(parameters.number("levels"));
    ControlPolygon polygon = control_polygon(surface, drawn, spacing, levels);
    const std::uint64_t control_points = polygon.points.size();
    for (int level = 0; level < levels; ++level) {
      go_on("subdivide", static_cast<double>(level) / levels);
      polygon =
          subdivided(surface, lines(), polygon, static_cast<int>(parameters.number("degree")));
    }
    MethodCurve made;
    made.curve = lines().join(polygon.points, polygon.closed);
    made.iterations = static_cast<std::size_t>(levels);
    made.entries = {{"spacing", spacing}, {"control_points", control_points}};
    if (!drawing().pins.empty()) {
      made.warnings.emplace_back(
          "This method ignores pins: the result need not pass the pinned points.");
    }
    return made;
  }
};

}  // namespace

const talweg_plugin* midpoints_plugin() { return plugin::Adapter<Midpoints>::plugin(); }

}  // namespace talweg::plugins

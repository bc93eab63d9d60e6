// talweg.measure: lengths and curvatures of curves on a mesh, and the distance between two sets of
// curves.
#include <span>
#include <string>
#include <vector>

#include "methods/plugins.hpp"
#include "methods/results.hpp"
#include "methods/workspace.hpp"
#include "talweg/core/measure/curve_measurement.hpp"

namespace talweg::plugins {
namespace {

class Measure : public Workspace {
 public:
  using Workspace::Workspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.measure", "Measure curves",
        "Length, geodesic curvature, bending and self-contacts of curves, and how far they lie "
        "from others along the surface, both ways. Points are joined straight over the surface.");
  }
  static std::vector<talweg_parameter> parameters() {
    return with_repair(
        {plugin::integer(
             "others", "Curves to compare with", 0, {0, 4294967294.0, 0, 16},
             "This many curves at the end of the list are compared with the curves before them: "
             "one by one in their order if the numbers are equal, else all together."),
         plugin::number("edge", "Edge length", "mesh units", 0, {0, HUGE_VAL, 0, 10},
                        "Length of the windows in which turning is measured. By default the mean "
                        "edge near each curve. Set the same length for curves that you compare.",
                        TALWEG_STAGE_RUN, TALWEG_OPTIONAL | TALWEG_OPEN_MINIMUM)});
  }
  static std::vector<talweg_output> outputs() {
    return {plugin::output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                           "Measures of each curve and in total.")};
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    const std::span<const SurfaceCurve> all = drawing().curves;
    const auto others = static_cast<std::size_t>(parameters.number("others"));
    if (others >= all.size()) {
      throw plugin::Failure(TALWEG_BAD_USAGE,
                            "Curves to compare with (others) must be less than all " +
                                std::to_string(all.size()) + " curves, not " +
                                std::to_string(others) + ".");
    }
    const std::size_t own = all.size() - others;
    CurveMeasurement measured = cancellable([&] {
      return measure_curves(mesh(), all.first(own), all.subspan(own), {parameters.optional("edge")},
                            progress());
    });
    SnappedDrawing moved = drawing();
    moved.gaps = {};  // the joined curve itself is measured
    moved.add_to(measured.warnings, moved.warnings());
    const std::vector<std::string>& changes = host_mesh().changes();
    measured.warnings.insert(measured.warnings.end(), changes.begin(), changes.end());
    const auto each = curve_entries_of(measured);
    give(outputs, -1, entries_of(measured));
    for (std::size_t c = 0; c < each.size(); ++c) {
      give(outputs, static_cast<std::int64_t>(c), each[c]);
    }
  }
};

}  // namespace

const talweg_plugin* measure_plugin() { return plugin::Adapter<Measure>::plugin(); }

}  // namespace talweg::plugins

// talweg.offset: curves at a distance along the surface from other curves.
#include <string>
#include <vector>

#include "methods/curve_choices.hpp"
#include "methods/plugins.hpp"
#include "methods/results.hpp"
#include "methods/workspace.hpp"
#include "talweg/core/offset/offset_curves.hpp"
#include "talweg/core/offset/offset_report.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kCaps[] = {"round", "none"};
constexpr const char* kCapLabels[] = {"Around the ends", "Cut off at the ends"};

OffsetOptions offset_options(const plugin::Parameters& parameters) {
  OffsetOptions options;
  const auto count = static_cast<std::size_t>(parameters.number("count"));
  for (std::size_t k = 1; k <= count; ++k) {
    options.distances.push_back(static_cast<double>(k) * parameters.number("distance"));
  }
  if (parameters.choice("side") == "left") options.side = CurveSide::kLeft;
  if (parameters.choice("side") == "right") options.side = CurveSide::kRight;
  if (parameters.choice("caps") == "none") options.caps = OffsetCaps::kNone;
  options.tolerance = parameters.optional("tolerance");
  return options;
}

class Offset : public Workspace {
 public:
  using Workspace::Workspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.offset", "Offset curves",
        "Curves at an exact distance along the surface from others, on both sides or on one: "
        "margins, bands, guides. Points are joined straight over the surface.");
  }
  static std::vector<talweg_parameter> parameters() {
    using plugin::choice, plugin::number;
    return with_repair(
        {number("distance", "Distance", "mesh units", 1, {0, HUGE_VAL, 0, 10},
                "Along the surface, to the nearest of the curves.", TALWEG_STAGE_RUN,
                TALWEG_OPEN_MINIMUM),
         plugin::integer("count", "Number of distances", 1, {1, 10000, 1, 10},
                         "Offsets are made at the distance, at twice the distance, and so on."),
         side_choice("side", "Side",
                     "The side as seen along the curve from outside; offsets on one side have no "
                     "caps."),
         choice("caps", "Caps", "round", kCaps, kCapLabels,
                "round: the offset runs around the ends of an open curve; none: the offset ends "
                "there."),
         ends_choice(),
         number("tolerance", "Tolerance", "mesh units", 0, {0, HUGE_VAL, 0, 1},
                "The largest error of the distance between two points. By default a thousandth of "
                "the distance, and at most a fiftieth of the mean edge.",
                TALWEG_STAGE_RUN, TALWEG_OPTIONAL | TALWEG_OPEN_MINIMUM | TALWEG_ADVANCED)});
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {output(TALWEG_OUTPUT_CURVES, "curves", "Offset curves", "",
                   "A curve for each component, in the order of the distances, the curves and "
                   "their sides."),
            output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                   "Side, length and error of each curve.")};
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    finish_ends(curve_ends(parameters.choice("ends")));
    const OffsetResult result = cancellable([&] {
      return offset_curves(mesh(), drawing().curves, offset_options(parameters), progress());
    });
    check_any(result);
    std::vector<std::string> warnings = result.warnings;
    drawing().add_to(warnings, reading_warnings());
    std::vector<SurfaceCurve> curves;
    for (const OffsetCurve& made : result.curves) curves.push_back(made.curve);
    const auto entries = [&](std::int64_t curve) {
      return curve < 0 ? entries_of(mesh(), result, warnings)
                       : curve_entries_of(result)[static_cast<std::size_t>(curve)];
    };
    give_curves(
        outputs, host_mesh(), curves, [](std::size_t) { return std::vector<PointField>(); },
        entries);
  }
};

}  // namespace

const talweg_plugin* offset_plugin() { return plugin::Adapter<Offset>::plugin(); }

}  // namespace talweg::plugins

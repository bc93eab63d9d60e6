// talweg.bipartition: relaxation of the border between two sides by heat flow (Livesu 2018).
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bipartition_field.hpp"
#include "face_sides.hpp"
#include "level_set.hpp"
#include "level_set_matching.hpp"
#include "methods/deviation_choice.hpp"
#include "methods/method_workspace.hpp"
#include "methods/plugins.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kWeights[] = {"area", "none"};
constexpr const char* kWeightLabels[] = {"By area", "All the same"};

class Bipartition : public MethodWorkspace {
 public:
  using MethodWorkspace::MethodWorkspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.bipartition", "Heat-flow relaxation of a bipartition (Livesu 2018)",
        "Another method, to compare with talweg.smooth: the curves separate the mesh into two "
        "sides; heat flows from their border, the directions of the flow are smoothed, and the "
        "zero set of the function that fits these directions is the result. Takes only loops that "
        "enclose something, and curves from boundary to boundary.");
  }
  static std::vector<talweg_parameter> parameters() {
    using plugin::number;
    return with_repair(
        {number("heat_time", "Heat time", "squared mean edge lengths", 1, {1e-3, 1e6, 0.1, 100},
                "How long heat flows from the border.", TALWEG_STAGE_RUN, TALWEG_LOGARITHMIC),
         plugin::integer("iterations", "Smoothing passes", 5, {0, 10000, 0, 100},
                         "Passes of smoothing over the directions of the flow: more is smoother."),
         number("anchor", "Anchor", "", 0.1, {1e-6, 1e6, 1e-3, 10},
                "How strongly the function is held at 0 on the border.", TALWEG_STAGE_RUN,
                TALWEG_LOGARITHMIC),
         plugin::choice("face_weights", "Weights of the faces", "area", kWeights, kWeightLabels,
                        "The weights of the faces in the fit. Equal weights are those of the "
                        "program that the method's author published.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED),
         plugin::boolean("guard", "Guard", true,
                         "Faces whose three corners are sources have no gradient; before smoothing "
                         "they take the directions of their neighbours.",
                         TALWEG_STAGE_RUN, TALWEG_ADVANCED),
         deviation_choice()});
  }

 private:
  Method smooth(const plugin::Parameters& parameters) override {
    const Stopwatch watch;
    const FaceSides sides = sides_of(mesh(), drawing().curves);
    BipartitionOptions options;
    options.heat_time = parameters.number("heat_time");
    options.passes = static_cast<int>(parameters.number("iterations"));
    options.anchor = parameters.number("anchor");
    options.area_weights = parameters.choice("face_weights") == "area";
    options.guard = parameters.flag("guard");
    const BipartitionField field = relax_bipartition(mesh(), sides.side, options, progress());
    if (field.cancelled) throw plugin::Services::cancelled();
    Method method{"bipartition", {}, {}};
    method.times.solve = watch.ms();
    const Stopwatch tracing;
    MatchedCurves found =
        match(mesh(), drawing().curves, zero_set(mesh().surface(), field.phi, field.known));
    double stray = 0;
    for (const SurfaceCurve& other : found.others) stray += curve_length(mesh().surface(), other);
    const std::vector<std::string> warnings = warnings_of(sides, found.others.size(), stray);
    for (SurfaceCurve& curve : found.curves) {
      MethodCurve& made = method.curves.emplace_back();
      made.curve = std::move(curve);
      made.iterations = static_cast<std::size_t>(options.passes);
      made.warnings = warnings;
      made.entries = {
          {"border_vertices", std::uint64_t{field.border_vertices}},
          {"source_faces", std::uint64_t{field.source_faces}},
          {"stray_curves", std::uint64_t{found.others.size()}},
          {"stray_length", stray},
      };
    }
    method.times.trace = tracing.ms();
    return method;
  }

  [[nodiscard]] std::vector<std::string> warnings_of(const FaceSides& sides, std::size_t strays,
                                                     double length) const {
    std::vector<std::string> warnings;
    if (!sides.exact) {
      warnings.emplace_back(
          "The drawing does not run along mesh edges; this method starts from the edges between "
          "the faces that lie mostly on either side of it.");
    }
    if (strays > 0) {
      warnings.push_back(fmt::format(
          "The level set has {} more curve{}, {} long, that belong{} to no drawn "
          "curve: a failure that this method is known for.",
          strays, strays > 1 ? "s" : "", mesh_units_text(length), strays > 1 ? "" : "s"));
    }
    if (!drawing().pins.empty()) {
      warnings.emplace_back(
          "This method ignores pins: the result need not pass the pinned points.");
    }
    return warnings;
  }
};

}  // namespace

const talweg_plugin* bipartition_plugin() { return plugin::Adapter<Bipartition>::plugin(); }

}  // namespace talweg::plugins

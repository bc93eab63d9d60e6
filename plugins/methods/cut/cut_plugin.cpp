// talweg.cut: curves become edges of the mesh, and the mesh is taken apart along them.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/curve_choices.hpp"
#include "methods/given_plan.hpp"
#include "methods/made_meshes.hpp"
#include "methods/plugins.hpp"
#include "methods/results.hpp"
#include "methods/workspace.hpp"
#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/core/cutting/cut_report.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kBorders[] = {"snap", "leave"};
constexpr const char* kBorderLabels[] = {"Extended to the border", "As they are"};
constexpr const char* kCaps[] = {"none", "auto", "planar", "least-area"};
constexpr const char* kCapLabels[] = {"None", "Planar for planar rims, else of least area", "Plane",
                                      "Of least area"};

PartOptions part_options(const plugin::Parameters& parameters) {
  PartOptions options;
  options.open = parameters.flag("open");
  options.split = parameters.flag("split");
  const std::string &keep = parameters.choice("keep"), &cap = parameters.choice("cap");
  if (keep == "left") options.keep = KeptSide::kLeft;
  if (keep == "right") options.keep = KeptSide::kRight;
  if (cap == "auto") options.lids = LidKind::kAuto;
  if (cap == "planar") options.lids = LidKind::kPlanar;
  if (cap == "least-area") options.lids = LidKind::kLeastArea;
  return options;
}

class Cut : public MakesMeshes<Workspace> {
 public:
  using MakesMeshes::MakesMeshes;

  static talweg_plugin about() {
    return about_curves(
        "talweg.cut", "Cut along curves",
        "Makes curves edges of the mesh, exactly: no vertex moves, new vertices lie on edges and "
        "in triangles only. Takes the mesh apart along the curves, if asked. Curves may cross and "
        "touch; points are joined straight over the surface.");
  }
  static std::vector<talweg_parameter> parameters() {
    using plugin::boolean, plugin::choice, plugin::number;
    return with_repair(
        {boolean("open", "Open the seam", false, "Either side of a curve has vertices of its own."),
         boolean("split", "A mesh for each piece", false,
                 "Otherwise the pieces are components of one mesh."),
         side_choice("keep", "Keep",
                     "Only pieces that lie on this side of every curve on their border, seen along "
                     "the curve from outside."),
         choice("cap", "Lids", "none", kCaps, kCapLabels,
                "Close the openings that the cut leaves. A lid never goes through the piece."),
         ends_choice(),
         choice("border", "Ends near the border", "snap", kBorders, kBorderLabels,
                "snap: where a seam is opened, ends of open curves within two edges of the mesh's "
                "border are extended straight to the border; leave: they stay.",
                TALWEG_STAGE_RUN, TALWEG_ADVANCED),
         number("merge", "Merge", "fraction of an edge", CutOptions{}.merge,
                {1e-11, 1e-2, 1e-9, 1e-2},
                "Points closer than this fraction of an edge to a vertex, an edge or each other "
                "become one point.",
                TALWEG_STAGE_RUN, TALWEG_ADVANCED | TALWEG_LOGARITHMIC)});
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {
        output(TALWEG_OUTPUT_MESH, "meshes", "Cut meshes", "",
               "One mesh, or one for each piece; with attributes and origin (talweg_meshes.h)."),
        output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
               "Numbers of the cut, and of each part.")};
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    made_.clear();
    plan_.reset();
    const Stopwatch watch;
    const PartOptions options = part_options(parameters);
    std::optional<ExtendedCurves> extended;
    if (options.opens() && border_ends(parameters.choice("border")) == BorderEnds::kSnap) {
      extended = ExtendedCurves::kAll;
    }
    finish_ends(curve_ends(parameters.choice("ends")), extended);
    CutPlan plan = cancellable([&] {
      return plan_cut(mesh(), drawing().curves, {parameters.number("merge")}, progress());
    });
    std::vector<std::string> warnings;
    drawing().add_to(warnings, reading_warnings());
    if (!outputs.wants_meshes() && !options.opens()) {
      go_on("cut", 1);
      give(outputs, -1, entries_of(mesh(), plan, warnings, watch.ms()));
    } else {
      cut_up(plan, options, outputs, warnings, watch);
    }
    plan_ = std::move(plan);
  }
  void give_cut_plan(const plugin::TakeCutPlan& take) const {
    if (!plan_) throw plugin::Failure(TALWEG_BAD_USAGE, "There is no plan; run() makes one.");
    give(take, *plan_, host_mesh());
  }

 private:
  void cut_up(const CutPlan& plan, const PartOptions& options, const plugin::Outputs& outputs,
              const std::vector<std::string>& warnings, const Stopwatch& watch) {
    const auto cut =
        std::make_shared<CutMesh>(cancellable([&] { return cut_by(mesh(), plan, progress()); }));
    MeshParts parts = taken_apart(*cut, options);
    give(outputs, -1, entries_of(mesh(), *cut, parts, warnings, watch.ms()));
    if (outputs.wants_meshes()) give_parts(outputs, std::move(parts.parts), cut);
  }
  void put(const std::vector<CurveInput>& curves) override {
    Workspace::put(curves);
    made_.clear();
    plan_.reset();
  }
  void forget() override {
    MakesMeshes::forget();
    plan_.reset();
  }

  std::optional<CutPlan> plan_;  // the plan of the last run
};

}  // namespace

const talweg_plugin* cut_plugin() { return plugin::Adapter<Cut>::plugin(); }

}  // namespace talweg::plugins

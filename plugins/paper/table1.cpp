// Table 1, and pictures as in Figures 3 and 4.
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "paper/ball.hpp"
#include "paper/contact_sheet.hpp"
#include "paper/experiment.hpp"
#include "paper/hand.hpp"
#include "talweg/core/mesh_reader.hpp"

namespace talweg::paper {
namespace {

// A row of the paper's table, and the mesh of about that size that stands for it here.
struct Row {
  const char* model;
  double tau;
  std::size_t points_before, points_after;
  double solve_ms, straighten_ms;  // on an Intel Core i9-13900K
  const char* mesh;                // of the shared meshes; null: always generated
  std::uint32_t frequency;         // of the generated ball
};

constexpr std::array<Row, 9> kRows{{
    {"Fandisk", 2.0, 257, 440, 2, 10, "fandisk_14k", 27},
    {"Bunny", 1.0, 196, 325, 4, 9, "aneurysm_14k", 27},
    {"Armadillo", 2.0, 555, 949, 7, 44, "armadillo_86k", 66},
    {"Dragon", 1.5, 548, 951, 27, 53, "skull_100k", 79},
    {"Sappho's Head", 2.5, 698, 1225, 70, 118, nullptr, 119},
    {"Grumpy Pumpkin", 1.8, 1258, 2202, 163, 199, nullptr, 141},
    {"Brain", 1.5, 1655, 3061, 171, 282, "skull_mri_585k", 166},
    {"Fox Skull", 1.5, 789, 1512, 227, 362, nullptr, 187},
    {"Fairing", 1.5, 2007, 3996, 450, 620, "mouse_skull_984k", 223},
}};

std::optional<MeshLists> shared_mesh(const Folders& folders, const Row& row) {
  if (row.mesh == nullptr) return std::nullopt;
  const auto file = folders.meshes / (std::string(row.mesh) + ".ply");
  if (!std::filesystem::exists(file)) return std::nullopt;
  return read_mesh(file);
}

picture::Image picture_of(const Experiment& experiment, const Row& row, const SurfaceCurve& smooth,
                          picture::Fit fit) {
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.curves = {
      experiment.tube(experiment.drawn(), kDrawnColor, fit == picture::Fit::kDetail ? 4 : 2.5),
      experiment.tube(smooth, kSmoothColor, fit == picture::Fit::kDetail ? 4 : 2.5)};
  picture::Panel panel;
  panel.caption = fmt::format("{}, tau = {}", row.model, row.tau);
  panel.fit = fit;
  scene.panels = {panel};
  picture::RenderOptions options;
  options.panel_width = options.panel_height = 330;
  options.supersampling = 2;
  options.mesh_edges = fit == picture::Fit::kDetail;
  return picture::render(scene, options);
}

}  // namespace

std::string table1(const Folders& folders) {
  std::string times =
      "| model | mesh here | faces | τ | n₀ | n | t [ms] | t_φ [ms] | t_λ [ms] | paper: faces' "
      "model "
      "n₀ → n | paper: t = t_φ + t_λ [ms] | once per mesh [ms] |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  std::string measures =
      "| model | n / n₀ (paper) | curvature drawn → smoothed [rad] | | length drawn → smoothed | "
      "largest deviation [h] | flips | ends |\n|---|--:|--:|--:|--:|--:|--:|---|\n";
  std::vector<picture::Image> overviews, details;
  std::uint64_t seed = 1;
  for (const Row& row : kRows) {
    std::optional<MeshLists> shared = shared_mesh(folders, row);
    const std::string mesh_name = shared ? row.mesh : "generated";
    Experiment experiment(shared ? std::move(*shared) : bumpy_ball(row.frequency, seed));
    experiment.set_drawing(tour(experiment.mesh(), row.points_before, seed++));
    const Timed timed = experiment.smooth(row.tau);
    const SmoothingReport& report = timed.result.report();
    times += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {} → {} | {} = {} + {} | "
        "{:.0f} "
        "|\n",
        row.model, mesh_name, report.faces, row.tau, report.points_before, report.points_after,
        timed.solve_ms + timed.straighten_ms, timed.solve_ms, timed.straighten_ms,
        row.points_before, row.points_after, row.solve_ms + row.straighten_ms, row.solve_ms,
        row.straighten_ms, experiment.open_ms());
    measures += fmt::format(
        "| {} | {:.2f} ({:.2f}) | {:.1f} → {:.1f} | {:+.0f} % | {:.4g} → {:.4g} | {:.2f} | {} | {} "
        "|\n",
        row.model, double(report.points_after) / double(report.points_before),
        double(row.points_after) / double(row.points_before), report.curvature_before,
        report.curvature_after, 100 * (report.curvature_after / report.curvature_before - 1),
        report.length_before, report.length_after,
        report.deviation_to_drawn_max / experiment.mesh().mesh().mean_edge_length(), report.flips,
        report.termination);
    fmt::print("{:15} {:8} faces: {:.1f} + {:.1f} ms\n", row.model, report.faces, timed.solve_ms,
               timed.straighten_ms);
    overviews.push_back(picture_of(experiment, row, timed.result.curve(), picture::Fit::kMesh));
    details.push_back(picture_of(experiment, row, timed.result.curve(), picture::Fit::kDetail));
  }
  picture::write_png(folders.out / "paper_models.png", contact_sheet(overviews, 3));
  picture::write_png(folders.out / "paper_models_details.png", contact_sheet(details, 3));
  return "## Table 1\n\n" + times + "\n" + measures +
         "\n![](pictures/paper_models.png)\n\n![](pictures/paper_models_details.png)\n";
}

}  // namespace talweg::paper

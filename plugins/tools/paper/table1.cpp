// Table 1, and pictures as in Figures 3 and 4.
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/mesh_reader.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/experiment.hpp"
#include "tools/paper/hand.hpp"
#include "tools/picture/contact_sheet.hpp"

namespace talweg::paper {
namespace {

// A row of the paper's table, with a mesh of about the same size.
struct Row {
  const char* model;
  double tau;
  std::size_t points_before, points_after;
  double total_ms, solve_ms, straighten_ms;  // on an Intel Core i9-13900K
  const char* mesh;                          // name of a shared mesh; null: always the generated
                                             // ball
  std::uint32_t frequency;                   // of the generated ball
};

constexpr std::array<Row, 9> kRows{{
    {"Fandisk", 2.0, 257, 440, 12, 2, 10, "fandisk_14k", 27},
    {"Bunny", 1.0, 196, 325, 13, 4, 9, "aneurysm_14k", 27},
    {"Armadillo", 2.0, 555, 949, 52, 7, 44, "armadillo_86k", 66},
    {"Dragon", 1.5, 548, 951, 80, 27, 53, "skull_100k", 79},
    {"Sappho's Head", 2.5, 698, 1225, 189, 70, 118, nullptr, 119},
    {"Grumpy Pumpkin", 1.8, 1258, 2202, 362, 163, 199, nullptr, 141},
    {"Brain", 1.5, 1655, 3061, 453, 171, 282, "skull_mri_585k", 166},
    {"Fox Skull", 1.5, 789, 1512, 589, 227, 362, nullptr, 187},
    {"Fairing", 1.5, 2007, 3996, 1070, 450, 620, "mouse_skull_984k", 223},
}};

std::optional<MeshLists> shared_mesh(const Folders& folders, const Row& row) {
  if (row.mesh == nullptr) return std::nullopt;
  const auto file = folders.meshes / (std::string(row.mesh) + ".ply");
  if (!std::filesystem::exists(file)) return std::nullopt;
  return read_mesh(file);
}

picture::Image picture_of(const Experiment& experiment, const std::string& caption,
                          const SurfaceCurve& smooth, picture::Fit fit) {
  const bool whole = fit == picture::Fit::kMesh;
  const double width = whole ? 2 : 3.5;
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.curves = {experiment.tube(experiment.drawn(), kDrawnColor, width),
                  experiment.tube(smooth, kSmoothColor, width)};
  picture::Panel panel;
  panel.caption = caption;
  panel.fit = fit;
  scene.panels = {panel};
  picture::RenderOptions options;
  options.panel_width = options.panel_height = whole ? 215 : 310;
  options.mesh_edges = !whole;
  return picture::render(scene, options);
}

constexpr const char* kTimesHead =
    "| model | mesh here | faces | τ | n₀ | n | paper's n | t [ms] | t_φ | t_λ | CPU, all of it | "
    "paper's t [ms] | "
    "paper's t_φ | paper's t_λ | once per mesh [ms] |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
constexpr const char* kMeasuresHead =
    "| model | n / n₀ | paper's n / n₀ | curvature drawn → smoothed [rad] | change | length drawn "
    "→ "
    "smoothed | largest deviation [h] | flips | ends |\n"
    "|---|--:|--:|--:|--:|--:|--:|--:|---|\n";

std::string times_of(const Row& row, const char* mesh, const Timed& timed, double open_ms) {
  const SmoothingReport& report = timed.result.report();
  return fmt::format(
      "| {} | {} | {} | {:.1f} | {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {} | {} | {} | "
      "{:.0f} "
      "|\n",
      row.model, mesh, report.faces, row.tau, report.points_before, report.points_after,
      row.points_after, timed.solve_ms + timed.straighten_ms, timed.solve_ms, timed.straighten_ms,
      timed.processor_ms, row.total_ms, row.solve_ms, row.straighten_ms, open_ms);
}

std::string measures_of(const Row& row, const SmoothingReport& report, double h) {
  return fmt::format(
      "| {} | {:.2f} | {:.2f} | {:.1f} → {:.1f} | {:+.0f} % | {:.4g} → {:.4g} | {:.2f} | {} | {} "
      "|\n",
      row.model, double(report.points_after) / double(report.points_before),
      double(row.points_after) / double(row.points_before), report.before.total_curvature,
      report.after.total_curvature,
      100 * (report.after.total_curvature / report.before.total_curvature - 1),
      report.before.length, report.after.length, report.deviation_to_drawn_max / h, report.flips,
      to_string(report.termination));
}

}  // namespace

std::string table1(const Folders& folders) {
  std::string times = kTimesHead, measures = kMeasuresHead;
  std::vector<picture::Image> overviews, details;
  std::uint64_t seed = 1;
  for (const Row& row : kRows) {
    std::optional<MeshLists> shared = shared_mesh(folders, row);
    const char* mesh = shared ? row.mesh : "generated";
    Experiment experiment(shared ? std::move(*shared) : bumpy_ball(row.frequency, seed + 10));
    experiment.set_drawing(tour(experiment.mesh(), row.points_before, seed++));
    const Timed timed = experiment.smooth(row.tau);
    const SmoothingReport& report = timed.result.report();
    times += times_of(row, mesh, timed, experiment.open_ms());
    measures += measures_of(row, report, experiment.mesh().mesh().mean_edge_length());
    std::printf("  %-15s %7zu faces: %.1f + %.1f ms\n", row.model, report.faces, timed.solve_ms,
                timed.straighten_ms);
    std::fflush(stdout);
    const std::string caption = fmt::format("{}k faces, tau = {}", report.faces / 1000, row.tau);
    overviews.push_back(picture_of(experiment, caption, timed.result.curve(), picture::Fit::kMesh));
    if (details.size() < 3) {
      details.push_back(
          picture_of(experiment, caption, timed.result.curve(), picture::Fit::kDetail));
    }
  }
  picture::write_png(folders.out / "paper_models.png", picture::contact_sheet(overviews, 3));
  picture::write_png(folders.out / "paper_details.png", picture::contact_sheet(details, 3));
  return "## Table 1\n\n" + times + "\n" + measures +
         "\n![](paper_models.png)\n\n![](paper_details.png)\n";
}

}  // namespace talweg::paper

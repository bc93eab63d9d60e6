// Figure 5: the influence of tau.
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tools/paper/experiment.hpp"
#include "tools/paper/hand.hpp"
#include "tools/picture/contact_sheet.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/scenes.hpp"

namespace talweg::paper {
namespace {

// A line in waves up the front of the vessel and over its aneurysm. The nearest vertices to places
// in front of it are on its front.
std::vector<Point> wave() {
  constexpr std::array<Point::Scalar, 7> kHeight{-1.35, -0.90, -0.42, 0.06, 0.36, 0.86, 1.15};
  constexpr std::array<Point::Scalar, 7> kMiddle{0.10, -0.22, -0.16, 0.00, 0.05, 0.20, 0.24};
  scenes::Random hand(3);
  std::vector<Point> places;
  std::size_t piece = 0;
  for (double y = kHeight.front(); y < kHeight.back(); y += 0.05) {
    while (y > kHeight[piece + 1]) ++piece;
    const double s = (y - kHeight[piece]) / (kHeight[piece + 1] - kHeight[piece]);
    const double x = std::lerp(kMiddle[piece], kMiddle[piece + 1], s) +
                     0.1 * std::sin(2 * std::numbers::pi * y / 0.7);
    places.emplace_back(x + hand.in(-0.02, 0.02), y, 0.45 + (y > 0.4 ? 0.25 : 0));
  }
  return places;
}

}  // namespace

std::string tau_figure(const Folders& folders) {
  Experiment experiment(scenes::vessel_scene().mesh);
  experiment.set_drawing(painted(experiment.mesh(), experiment.lists(), wave(), false));
  std::string text =
      "| τ | n₀ | n | t_φ [ms] | t_λ [ms] | flips | length | curvature [rad] | largest / mean "
      "deviation [h] |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  const double h = experiment.mesh().mesh().mean_edge_length();
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.curves.push_back(experiment.tube(experiment.drawn(), kDrawnColor, 3));
  for (const double tau : {0.0, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    const Timed timed = experiment.smooth(tau);
    const SmoothingReport& report = timed.result.report();
    if (tau == 0) {
      text += fmt::format("| drawn | {} | | | | | {:.3f} | {:.1f} | |\n", report.points_before,
                          report.before.length, report.before.total_curvature);
    }
    text += fmt::format(
        "| {} | {} | {} | {:.1f} | {:.2f} | {} | {:.3f} | {:.1f} | {:.2f} / {:.2f} |\n", tau,
        report.points_before, report.points_after, timed.solve_ms, timed.straighten_ms,
        report.flips, report.after.length, report.after.total_curvature,
        report.deviation_to_drawn_max / h, report.deviation_to_drawn_mean / h);
    picture::Panel panel;
    panel.caption = fmt::format("tau = {}", tau);
    panel.curves = {0, scene.curves.size()};
    panel.fit = picture::Fit::kCurve;
    panel.view = Point(0.1, 0, 1);
    scene.curves.push_back(experiment.tube(timed.result.curve(), kSmoothColor, 4));
    scene.panels.push_back(panel);
  }
  picture::RenderOptions options;
  options.panel_width = 220;
  options.panel_height = 520;
  options.mesh_edges = false;
  picture::write_png(folders.out / "paper_tau.png", picture::render(scene, options));
  return "## Figure 5: τ\n\n![](paper_tau.png)\n\n" + text;
}

}  // namespace talweg::paper

// Figure 9: a coarse mesh, without and with relaxation.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tools/paper/ball.hpp"
#include "tools/paper/experiment.hpp"
#include "tools/paper/hand.hpp"
#include "tools/scenes/random.hpp"

namespace talweg::paper {
namespace {

// A closed, uneven line around the ball's front.
std::vector<Point> ring() {
  scenes::Random hand(4);
  std::vector<Point> places;
  constexpr int kCount = 20;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    const double r = 0.6 + 0.12 * std::sin(3 * angle) + hand.in(-0.04, 0.04);
    places.emplace_back(r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - r * r));
  }
  return places;
}

}  // namespace

std::string relaxation_figure(const Folders& folders) {
  constexpr double kTau = 2;
  Experiment experiment(bumpy_ball(9, 6));
  experiment.set_drawing(painted(experiment.mesh(), experiment.lists(), ring(), true));
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.curves.push_back(experiment.tube(experiment.drawn(), kDrawnColor, 3));
  std::string text =
      "| rounds | n | length | curvature [rad] | sharpest turn [rad] | largest deviation [h] |\n"
      "|--:|--:|--:|--:|--:|--:|\n";
  const double h = experiment.mesh().mesh().mean_edge_length();
  for (const int rounds : {0, 5, 50}) {
    const Timed timed = experiment.smooth(kTau, rounds);
    const SmoothingReport& report = timed.result.report();
    if (rounds == 0) {
      text += fmt::format("| drawn | {} | {:.4f} | {:.1f} | {:.2f} | |\n", report.points_before,
                          report.before.length, report.before.total_curvature,
                          report.before.max_curvature);
    }
    text += fmt::format("| {} | {} | {:.4f} | {:.1f} | {:.2f} | {:.2f} |\n", rounds,
                        report.points_after, report.after.length, report.after.total_curvature,
                        report.after.max_curvature, report.deviation_to_drawn_max / h);
    if (rounds > 5) continue;
    picture::Panel panel;
    panel.caption = rounds == 0 ? "Not relaxed" : fmt::format("Relaxed, {} rounds", rounds);
    panel.curves = {0, scene.curves.size()};
    panel.fit = picture::Fit::kMesh;
    panel.view = Point(0, 0, 1);
    scene.curves.push_back(experiment.tube(timed.result.curve(), kSmoothColor, 3.5));
    scene.panels.push_back(panel);
  }
  picture::RenderOptions options;
  options.panel_width = options.panel_height = 440;
  picture::write_png(folders.out / "paper_relaxed.png", picture::render(scene, options));
  return fmt::format(
             "## Figure 9: a coarse mesh\n\n![](paper_relaxed.png)\n\n"
             "{} faces, τ = {}.\n\n",
             experiment.lists().triangles.size(), kTau) +
         text;
}

}  // namespace talweg::paper

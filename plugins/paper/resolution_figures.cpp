// Figures 6 and 7: meshes whose resolution changes.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "paper/ball.hpp"
#include "paper/experiment.hpp"
#include "paper/hand.hpp"
#include "paper/refinement.hpp"
#include "scenes/random.hpp"
#include "talweg/core/measures.hpp"

namespace talweg::paper {
namespace {

// Turning angles per unit length where x is in [low, high).
double bending(const SurfaceMesh& mesh, const SurfaceCurve& curve, double low, double high) {
  const std::size_t n = curve.points.size();
  const std::vector<Point> at = positions_of(mesh, curve);
  double turned = 0, length = 0;
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (at[i].x() < low || at[i].x() >= high) continue;
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    turned +=
        turning_angle(mesh.surface(), curve.points[before], curve.points[i], curve.points[after]);
    length += 0.5 * ((at[i] - at[before]).norm() + (at[after] - at[i]).norm());
  }
  return length > 0 ? turned / length : 0;
}

double mean_edge(const SurfaceMesh& mesh, double low, double high) {
  const Surface& surface = mesh.surface();
  double sum = 0, count = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& a = mesh.point(corners[k]);
      const Point& b = mesh.point(corners[(k + 1) % 3]);
      if (a.x() < low || a.x() >= high) continue;
      sum += (a - b).norm();
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

// A circle in the disc, drawn by an unsteady hand.
std::vector<Point> circle() {
  scenes::Random hand(7);
  std::vector<Point> places;
  constexpr int kCount = 44;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * (i + hand.in(-0.2, 0.2)) / kCount;
    const double r = 0.62 + hand.in(-0.035, 0.035);
    places.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return places;
}

// A wave over the front of the ball from left to right.
std::vector<Point> wave() {
  scenes::Random hand(8);
  std::vector<Point> places;
  for (double x = -0.92; x < 0.92; x += 0.045) {
    places.emplace_back(1.1 * x, 0.22 * std::sin(4.5 * x) + hand.in(-0.035, 0.035),
                        1.1 * std::sqrt(1 - x * x));
  }
  return places;
}

struct Part {
  const char* name;
  double low, high;
};

std::string report_on(Experiment& experiment, double tau, const std::vector<Part>& parts,
                      const std::filesystem::path& file, const Point& view) {
  const Timed timed = experiment.smooth(tau);
  const SmoothingReport& report = timed.result.report();
  const SurfaceMesh& mesh = experiment.mesh().mesh();
  std::string text = fmt::format(
      "{} faces, τ = {}, n₀ = {}, n = {}, curvature {:.1f} → {:.1f} rad, {}.\n\n"
      "| part | mean edge | turning drawn → smoothed [rad per unit length] |\n|---|--:|--:|\n",
      report.faces, tau, report.points_before, report.points_after, report.curvature_before,
      report.curvature_after, report.termination);
  for (const Part& part : parts) {
    text += fmt::format("| {} | {:.4f} | {:.1f} → {:.1f} |\n", part.name,
                        mean_edge(mesh, part.low, part.high),
                        bending(mesh, experiment.drawn(), part.low, part.high),
                        bending(mesh, timed.result.curve(), part.low, part.high));
  }
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.up = Point(0, 1, 0);
  scene.curves = {experiment.tube(experiment.drawn(), kDrawnColor, 3.5),
                  experiment.tube(timed.result.curve(), kSmoothColor, 4)};
  picture::Panel panel;
  panel.caption = fmt::format("tau = {}", tau);
  panel.fit = picture::Fit::kMesh;
  panel.view = view;
  scene.panels = {panel};
  picture::RenderOptions options;
  options.panel_width = options.panel_height = 800;
  picture::write_png(file, picture::render(scene, options));
  return text;
}

std::string sudden_change(const Folders& folders) {
  MeshLists mesh = disc(16);
  for (int k = 0; k < 3; ++k) {
    mesh = refined(mesh, [](const Point& p) { return p.x() > 0; });
  }
  Experiment experiment(std::move(mesh));
  experiment.set_drawing(painted(experiment.mesh(), experiment.lists(), circle(), true));
  return "## Figure 6: a sudden change of resolution\n\n![](pictures/paper_sudden.png)\n\n" +
         report_on(experiment, 2, {{"coarse (left)", -1, 0}, {"fine (right)", 0, 1}},
                   folders.out / "paper_sudden.png", Point(0, 0, 1));
}

std::string continuous_change(const Folders& folders) {
  MeshLists mesh = sphere(20);
  for (const double from : {-0.55, 0.0, 0.55}) {
    mesh = refined(mesh, [&](const Point& p) { return p.x() > from; });
    for (Point& p : mesh.points) p.normalize();
  }
  make_bumpy(mesh, 5);
  Experiment experiment(std::move(mesh));
  experiment.set_drawing(painted(experiment.mesh(), experiment.lists(), wave(), false));
  return "## Figure 7: ever finer\n\n![](pictures/paper_finer.png)\n\n" +
         report_on(experiment, 1.5,
                   {{"coarsest", -9, -0.55},
                    {"coarse", -0.55, 0},
                    {"fine", 0, 0.55},
                    {"finest", 0.55, 9}},
                   folders.out / "paper_finer.png", Point(0, 0, 1));
}

}  // namespace

std::string resolution_figures(const Folders& folders) {
  return sudden_change(folders) + "\n" + continuous_change(folders);
}

}  // namespace talweg::paper

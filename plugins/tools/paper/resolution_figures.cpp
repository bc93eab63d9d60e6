// Figures 6 and 7: meshes whose resolution changes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "talweg/core/measure/measures.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/experiment.hpp"
#include "tools/paper/hand.hpp"
#include "tools/paper/refinement.hpp"
#include "tools/scenes/random.hpp"

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
  constexpr int kCount = 70;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * (i + hand.in(-0.2, 0.2)) / kCount;
    const double r = 0.62 + hand.in(-0.03, 0.03);
    places.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return places;
}

// An arched wave over the front of the ball from left to right.
std::vector<Point> arched_wave() {
  scenes::Random hand(8);
  std::vector<Point> places;
  for (double x = -0.8; x < 0.8; x += 0.03) {
    places.emplace_back(1.1 * x, 0.25 * std::sin(4.5 * x) + hand.in(-0.02, 0.02),
                        1.1 * std::sqrt(1 - x * x));
  }
  return places;
}

struct Part {
  const char* name;
  double low, high;
};

// The mesh's edges as thin lines, since the renderer leaves out such short edges.
void add_wires(const MeshLists& mesh, picture::Scene& scene) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a > b) continue;
      scene.curves.push_back({{mesh.points[a], mesh.points[b]}, false, {0.66, 0.61, 0.55}, 0.5});
    }
  }
}

// A panel and a part of the table for each tau.
std::string report_on(Experiment& experiment, const std::vector<double>& taus,
                      const std::vector<Part>& parts, const std::filesystem::path& file) {
  const SurfaceMesh& mesh = experiment.mesh().mesh();
  picture::Scene scene;
  scene.mesh = experiment.lists();
  scene.up = Point(0, 1, 0);
  add_wires(experiment.lists(), scene);
  scene.curves.push_back(experiment.tube(experiment.drawn(), kDrawnColor, 3));
  std::vector<std::size_t> common(scene.curves.size());
  std::iota(common.begin(), common.end(), std::size_t{0});

  std::string text = fmt::format(
      "{} faces. Turning per length: in rad per unit length; the ball or disc has radius 1.\n\n"
      "| τ | part | mean edge | n₀ → n, all | curvature drawn → smoothed [rad], all | turning per "
      "length drawn → smoothed | ends |\n|--:|---|--:|--:|--:|--:|---|\n",
      mesh.surface().face_count());
  for (const double tau : taus) {
    const Timed timed = experiment.smooth(tau);
    const SmoothingReport& report = timed.result.report();
    for (const Part& part : parts) {
      text += fmt::format(
          "| {} | {} | {:.4f} | {} → {} | {:.1f} → {:.1f} | {:.1f} → {:.1f} | {} |\n", tau,
          part.name, mean_edge(mesh, part.low, part.high), report.points_before,
          report.points_after, report.before.total_curvature, report.after.total_curvature,
          bending(mesh, experiment.drawn(), part.low, part.high),
          bending(mesh, timed.result.curve(), part.low, part.high), to_string(report.termination));
    }
    picture::Panel panel;
    panel.caption = fmt::format("tau = {}", tau);
    panel.fit = picture::Fit::kMesh;
    panel.view = Point(0, 0, 1);
    panel.curves = common;
    panel.curves.push_back(scene.curves.size());
    scene.curves.push_back(experiment.tube(timed.result.curve(), kSmoothColor, 3.5));
    scene.panels.push_back(std::move(panel));
  }
  picture::RenderOptions options;
  options.panel_width = options.panel_height = std::min<std::size_t>(1200 / taus.size(), 480);
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
  return "## Figure 6: a sudden change of resolution\n\n![](paper_sudden.png)\n\n" +
         report_on(experiment, {0.5, 0.7, 1}, {{"coarse (left)", -1, 0}, {"fine (right)", 0, 1}},
                   folders.out / "paper_sudden.png");
}

std::string continuous_change(const Folders& folders) {
  MeshLists mesh = sphere(20);
  for (const double from : {-0.55, 0.0, 0.55}) {
    mesh = refined(mesh, [&](const Point& p) { return p.x() > from; });
    for (Point& p : mesh.points) p.normalize();
  }
  make_bumpy(mesh, 2);
  Experiment experiment(std::move(mesh));
  experiment.set_drawing(painted(experiment.mesh(), experiment.lists(), arched_wave(), false));
  return "## Figure 7: ever finer\n\n![](paper_finer.png)\n\n" +
         report_on(experiment, {0.5, 1.5},
                   {{"coarsest", -9, -0.55},
                    {"coarse", -0.55, 0},
                    {"fine", 0, 0.55},
                    {"finest", 0.55, 9}},
                   folders.out / "paper_finer.png");
}

}  // namespace

std::string resolution_figures(const Folders& folders) {
  return sudden_change(folders) + "\n" + continuous_change(folders);
}

}  // namespace talweg::paper

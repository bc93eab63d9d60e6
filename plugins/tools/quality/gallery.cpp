#include "tools/quality/gallery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "tools/picture/contact_sheet.hpp"
#include "tools/picture/curvature_plot.hpp"
#include "tools/picture/image.hpp"
#include "tools/picture/render.hpp"

namespace talweg::quality {
namespace {

constexpr picture::Color kDrawn{0.78, 0.16, 0.12}, kTaut{0.90, 0.55, 0.05}, kFair{0.08, 0.31, 0.75};
constexpr double kShownTau = 1;
constexpr double kShownRadius = 9;  // edge lengths

/// A curve with its caption.
struct Shown {
  std::string name;
  SurfaceCurve curve;
  picture::Color color;
};

SurfaceCurve smoothed(const Subject& subject, const SurfaceCurve& drawn, Finish finish) {
  SmoothingOptions options;
  options.tau = kShownTau;
  options.finish = finish;
  return smooth_curve(subject.mesh, drawn, options).curve();
}

/// The point at this length along a curve.
Point point_at(const picture::PictureCurve& curve, double length) {
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Point along = curve.points[i + 1] - curve.points[i];
    if (along.norm() >= length) return curve.points[i] + length / along.norm() * along;
    length -= along.norm();
  }
  return curve.points.back();
}

/// The place where a curve turns most within a window of this length.
Point most_turning(const Surface& surface, const Shown& shown, const picture::PictureCurve& tube,
                   double window) {
  const std::vector<CurvatureStep> steps = curvature_along(turns_of(surface, shown.curve), window);
  const auto most = std::max_element(steps.begin(), steps.end(),
                                     [](const CurvatureStep& a, const CurvatureStep& b) {
                                       return std::abs(a.curvature) < std::abs(b.curvature);
                                     });
  return most == steps.end() ? tube.points.front() : point_at(tube, (most->from + most->to) / 2);
}

std::string caption(const Surface& surface, const Shown& shown, double edge) {
  const CurveMeasures m = measure_curve(surface, shown.curve, edge);
  return fmt::format("{}: bending {:.{}f}, turn {:.0f} degrees", shown.name, m.bending,
                     m.bending < 10 ? 2 : 0, m.window_turning * 180 / std::numbers::pi);
}

/// A panel for each curve; panels after the first also have the drawing as a thin line.
picture::Scene scene_of(const Subject& subject, const std::array<Shown, 3>& all, double edge) {
  const SurfaceMesh& mesh = subject.mesh->mesh();
  picture::Scene scene;
  scene.mesh = subject.lists;
  for (const Shown& shown : all) {
    picture::Panel panel;
    panel.caption = caption(mesh.surface(), shown, edge);
    panel.curves = {scene.curves.size()};
    if (!scene.panels.empty()) panel.curves.insert(panel.curves.begin(), all.size());
    scene.curves.push_back({positions_of(mesh, shown.curve), shown.curve.closed, shown.color, 4});
    scene.panels.push_back(std::move(panel));
  }
  picture::PictureCurve thin = scene.curves.front();
  thin.width = 1.3;
  scene.curves.push_back(std::move(thin));
  return scene;
}

picture::CurvaturePlot plot_of(const Surface& surface, const std::array<Shown, 3>& all,
                               double edge) {
  picture::CurvaturePlot plot;
  plot.edge = edge;
  for (const Shown& shown : all) {
    plot.lines.push_back(
        {shown.name, curvature_along(turns_of(surface, shown.curve), edge / 2), shown.color});
  }
  plot.lines.front().behind = true;
  return plot;
}

}  // namespace

std::vector<NamedPath> gallery_drawings(const Subject& subject) {
  std::vector<NamedPath> stored;
  const NamedPath* longest = nullptr;
  for (const NamedPath& drawing : subject.drawings) {
    if (drawing.name.starts_with("stored")) stored.push_back(drawing);
    if (longest == nullptr || (!drawing.closed && drawing.path.size() > longest->path.size())) {
      longest = &drawing;
    }
  }
  if (stored.empty() && longest != nullptr) stored.push_back(*longest);
  return stored;
}

void write_gallery_picture(const Subject& subject, const NamedPath& drawing,
                           const std::filesystem::path& file) {
  const Surface& surface = subject.mesh->mesh().surface();
  const SurfaceCurve drawn = drawing.curve(surface);
  const std::array<Shown, 3> all{{{"drawn", drawn, kDrawn},
                                  {"taut", smoothed(subject, drawn, Finish::kTaut), kTaut},
                                  {"fair", smoothed(subject, drawn, Finish::kFair), kFair}}};
  const double edge = edge_length_near(surface, drawn);
  picture::Scene scene = scene_of(subject, all, edge);
  const Point place = most_turning(surface, all[1], scene.curves[1], edge);
  const picture::Detail detail = picture::detail_at(scene, place, kShownRadius * edge);
  for (picture::Panel& panel : scene.panels) panel.detail = detail;
  picture::CurvaturePlot plot = plot_of(surface, all, edge);
  plot.shown = picture::stretches_in(scene.curves[2], detail.center, detail.radius);
  picture::RenderOptions size;
  size.panel_width = size.panel_height = 360;
  const picture::Image panels = picture::render(scene, size);
  picture::write_png(file,
                     picture::stacked(panels, picture::draw_curvature(plot, panels.width, 190)));
}

}  // namespace talweg::quality

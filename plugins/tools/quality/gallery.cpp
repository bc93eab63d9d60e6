#include "tools/quality/gallery.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measure/measures.hpp"
#include "tools/picture/image.hpp"
#include "tools/picture/render.hpp"

namespace talweg::quality {
namespace {

constexpr std::array<std::string_view, 6> kGallery{"aneurysm_14k",    "armadillo_86k",
                                                   "skull_100k",      "tooth_ct_119k",
                                                   "brain_icbm_164k", "terrain_utm_21k"};
constexpr picture::Color kDrawn{0.78, 0.16, 0.12}, kPaper{0.45, 0.12, 0.55},
    kDefault{0.08, 0.31, 0.75};
constexpr double kShownTau = 1;
constexpr int kPaperRelaxes = 5;  // rounds, as its authors do

const NamedPath& chosen(const Subject& subject) {
  const NamedPath& first = subject.drawings.front();
  if (first.name.starts_with("stored")) return first;
  const NamedPath* longest = &first;
  for (const NamedPath& drawing : subject.drawings) {
    if (!drawing.closed && drawing.path.size() > longest->path.size()) longest = &drawing;
  }
  return *longest;
}

void add(picture::Scene& scene, const SurfaceMesh& mesh, const SurfaceCurve& curve,
         const picture::Color& color, std::string caption) {
  picture::Panel panel;
  panel.caption = std::move(caption);
  panel.curves = {scene.curves.size()};
  panel.fit = picture::Fit::kDetail;
  scene.curves.push_back({positions_of(mesh, curve), curve.closed, color, 4});
  scene.panels.push_back(std::move(panel));
}

SmoothingResult smoothed(const Subject& subject, const SurfaceCurve& drawn, Method method,
                         int relax_rounds) {
  SmoothingOptions options;
  options.tau = kShownTau;
  options.relax_rounds = relax_rounds;
  CurveOptions curve_options;
  curve_options.method = method;
  return smooth_curve(subject.mesh, drawn, options, curve_options);
}

std::string turning(const SmoothingResult& result) {
  const double curvature = result.report().curvature_after;
  return fmt::format("{:.{}f}", curvature, curvature < 10 ? 1 : 0);
}

}  // namespace

bool in_gallery(const std::string& mesh) {
  return std::find(kGallery.begin(), kGallery.end(), mesh) != kGallery.end();
}

void write_gallery_picture(const Subject& subject, const std::filesystem::path& file) {
  const SurfaceMesh& mesh = subject.mesh->mesh();
  const SurfaceCurve drawn = chosen(subject).curve(mesh.surface());
  picture::Scene scene;
  scene.mesh = subject.lists;
  add(scene, mesh, drawn, kDrawn,
      fmt::format("drawing: {:.0f} rad", measure_curve(mesh.surface(), drawn).total_curvature));
  const SmoothingResult paper = smoothed(subject, drawn, Method::kPaper, 0),
                        relaxed = smoothed(subject, drawn, Method::kPaper, kPaperRelaxes),
                        corridor = smoothed(subject, drawn, Method::kCorridor, 0);
  add(scene, mesh, paper.curve(), kPaper,
      fmt::format("paper, tau = {}: {} rad, relaxed {}", kShownTau, turning(paper),
                  turning(relaxed)));
  add(scene, mesh, corridor.curve(), kDefault,
      fmt::format("default, tau = {}: {} rad", kShownTau, turning(corridor)));
  picture::RenderOptions size;
  size.panel_width = size.panel_height = 400;
  picture::write_png(file, picture::render(scene, size));
}

}  // namespace talweg::quality

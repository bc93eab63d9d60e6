#include "compare/picture.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "picture/render.hpp"

namespace talweg::driver {
namespace {

picture::Color color_of(const std::string& rrggbb) {
  const unsigned long value = std::stoul(rrggbb, nullptr, 16);
  return {static_cast<double>(value >> 16U) / 255, static_cast<double>(value >> 8U & 255U) / 255,
          static_cast<double>(value & 255U) / 255};
}

std::vector<std::size_t> add(picture::Scene& scene, const std::vector<PlacedCurve>& curves,
                             const std::string& color, double width) {
  std::vector<std::size_t> numbers;
  for (const PlacedCurve& curve : curves) {
    numbers.push_back(scene.curves.size());
    scene.curves.push_back({curve.positions, curve.closed, color_of(color), width});
  }
  return numbers;
}

/// The run that stands for a method: the middle one of its sweep, or null where it refused.
const ComparedRun* run_of(const Comparison& c, std::size_t method) {
  std::vector<const ComparedRun*> runs;
  for (const ComparedRun& run : c.runs) {
    if (run.method == method && run.refusal.empty()) runs.push_back(&run);
  }
  return runs.empty() ? nullptr : runs[runs.size() / 2];
}

}  // namespace

void write_comparison_picture(const std::filesystem::path& path, const Comparison& c,
                              const MeshLists& mesh) {
  picture::Scene scene;
  scene.mesh = mesh;
  const std::vector<std::size_t> drawing = add(scene, c.drawing, "c8281e", 3);
  scene.panels.push_back({"drawing and all methods", {}, picture::Fit::kAuto, 1, {}});
  for (std::size_t m = 0; m < c.methods.size(); ++m) {
    const ComparedRun* run = run_of(c, m);
    if (run == nullptr) continue;
    picture::Panel panel{fmt::format("{}: {:.1f} rad", c.methods[m].name, run->numbers.curvature),
                         drawing,
                         picture::Fit::kDetail,
                         1,
                         {}};
    for (const std::size_t k : add(scene, run->curves, c.methods[m].color, 4)) {
      panel.curves.push_back(k);
    }
    scene.panels.push_back(std::move(panel));
  }
  picture::RenderOptions options;
  options.panel_width = options.panel_height = 400;
  picture::write_png(path, picture::render(scene, options));
}

}  // namespace talweg::driver

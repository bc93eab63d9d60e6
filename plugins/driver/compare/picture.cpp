#include "compare/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/picture/render.hpp"

namespace talweg::driver {
namespace {

constexpr double kEdges = 1.5;       // the deviation at which methods are compared
constexpr std::size_t kColumns = 5;  // of panels

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

/// The run shown for a method: in a sweep the one whose deviation is nearest to `edges`; null if
/// the method refused.
const ComparedRun* run_of(const Comparison& c, std::size_t method, double edges) {
  const ComparedRun* best = nullptr;
  const auto off = [&](const ComparedRun& run) {
    return std::abs(std::log(std::max(run.deviation() / c.edge, 1e-3) / edges));
  };
  for (const ComparedRun& run : c.runs) {
    if (run.method != method || !run.refusal.empty()) continue;
    if (best == nullptr || off(run) < off(*best)) best = &run;
  }
  return best;
}

/// Stacks the rows vertically; short rows are filled with their first pixel, the background.
picture::Image stacked(const std::vector<picture::Image>& rows) {
  picture::Image all{rows.front().width, 0, {}};
  for (const picture::Image& row : rows) {
    for (std::size_t y = 0; y < row.height; ++y) {
      for (std::size_t x = 0; x < all.width; ++x) {
        const std::uint8_t* pixel = row.pixel(x < row.width ? x : 0, x < row.width ? y : 0);
        all.rgb.insert(all.rgb.end(), pixel, pixel + 3);
      }
    }
    all.height += row.height;
  }
  return all;
}

}  // namespace

std::string comparison_picture(const Comparison& c, const MeshLists& mesh) {
  picture::Scene scene;
  scene.mesh = mesh;
  const std::vector<std::size_t> drawing = add(scene, c.drawing, "c8281e", 3);
  std::vector<picture::Panel> panels{{"all", {}, picture::Fit::kAuto, 1, {}}};
  for (std::size_t m = 0; m < c.methods.size(); ++m) {
    const ComparedRun* run = run_of(c, m, kEdges);
    if (run == nullptr) continue;
    picture::Panel panel{fmt::format("{}: {:.1f} rad, {:.1f} edges", c.methods[m].name,
                                     run->numbers.curvature, run->deviation() / c.edge),
                         drawing,
                         picture::Fit::kDetail,
                         1,
                         {}};
    for (const std::size_t k : add(scene, run->curves, c.methods[m].color, 4)) {
      panel.curves.push_back(k);
    }
    panels.push_back(std::move(panel));
  }
  picture::RenderOptions options;
  options.panel_width = options.panel_height = 400;
  std::vector<picture::Image> rows;
  for (std::size_t first = 0; first < panels.size(); first += kColumns) {
    scene.panels.clear();
    for (std::size_t k = first; k < std::min(first + kColumns, panels.size()); ++k) {
      scene.panels.push_back(panels[k]);
    }
    rows.push_back(picture::render(scene, options));
  }
  return picture::png_bytes(stacked(rows));
}

}  // namespace talweg::driver

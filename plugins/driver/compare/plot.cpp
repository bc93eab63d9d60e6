#include "compare/plot.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace talweg::driver {
namespace {

constexpr double kWidth = 640, kHeight = 420;
constexpr double kLeft = 62, kRight = 150, kTop = 34, kBottom = 46;

/// A logarithmic axis from `low` to `high` (logarithms) to pixels.
struct Axis {
  double low = 0, high = 1, first = 0, last = 1;
  [[nodiscard]] double at(double value) const {
    return first + (last - first) * (std::log10(value) - low) / (high - low);
  }
  void take(double value) {
    low = std::min(low, std::log10(value));
    high = std::max(high, std::log10(value));
  }
};

/// Smaller values are not distinguished: 1e-3 edges, 1e-2 rad.
double edges_of(const Comparison& c, const ComparedRun& run) {
  return std::max(run.deviation() / c.edge, 1e-3);
}
double curvature_of(const ComparedRun& run) { return std::max(run.numbers.curvature, 1e-2); }

void fit(const Comparison& c, Axis& x, Axis& y) {
  x.low = y.low = 1e9;
  x.high = y.high = -1e9;
  y.take(std::max(c.drawn.curvature, 1e-2));
  for (const ComparedRun& run : c.runs) {
    if (!run.refusal.empty() || !std::isfinite(run.deviation())) continue;
    x.take(edges_of(c, run));
    y.take(curvature_of(run));
  }
  for (Axis* axis : {&x, &y}) {
    if (axis->low > axis->high) *axis = {0, 1, axis->first, axis->last};
    axis->low -= 0.05;
    axis->high += 0.05;
  }
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& more = "") {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, escaped);
}

std::string grid_line(bool upright, double at) {
  if (upright) {
    return fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n", at, kTop,
        kHeight - kBottom);
  }
  return fmt::format(
      "<line y1=\"{0:.1f}\" y2=\"{0:.1f}\" x1=\"{1}\" x2=\"{2}\" stroke=\"#ddd\"/>\n", at, kLeft,
      kWidth - kRight);
}

/// Grid lines at 1, 2 and 5 times the powers of ten.
std::string grid(const Axis& axis, bool upright) {
  std::string svg;
  for (int decade = -4; decade < 8; ++decade) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = step * std::pow(10.0, decade);
      if (std::log10(value) < axis.low || std::log10(value) > axis.high) continue;
      const double at = axis.at(value);
      svg += grid_line(upright, at);
      const std::string label = fmt::format("{:g}", value);
      svg += upright ? text_at(at, kHeight - kBottom + 16, "middle", label)
                     : text_at(kLeft - 6, at + 4, "end", label);
    }
  }
  return svg;
}

std::string line_of(const Comparison& c, std::size_t method, const Axis& x, const Axis& y) {
  const std::string color = "#" + c.methods[method].color;
  std::string path, marks;
  bool pen = false;
  for (const ComparedRun& run : c.runs) {
    if (run.method != method) continue;
    if (!run.refusal.empty() || !std::isfinite(run.deviation())) {
      pen = false;
      continue;
    }
    const double px = x.at(edges_of(c, run)), py = y.at(curvature_of(run));
    const bool kept = run.changed.empty();
    if (kept) path += fmt::format("{}{:.1f} {:.1f}", pen ? " L" : " M", px, py);
    pen = kept;
    marks +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\" fill=\"{}\" stroke=\"{}\"/>\n",
                    px, py, kept ? color : "white", color);
  }
  if (path.empty()) return marks;
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n",
                     path.substr(1), color) +
         marks;
}

std::string legend(const Comparison& c) {
  std::string svg;
  double y = kTop + 12;
  for (const Method& method : c.methods) {
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#{}\"/>\n",
                       kWidth - kRight + 16, y - 4, method.color);
    svg += text_at(kWidth - kRight + 26, y, "start", method.name);
    y += 18;
  }
  return svg;
}

}  // namespace

std::string comparison_plot(const Comparison& c, const std::string& title) {
  Axis x{0, 1, kLeft, kWidth - kRight}, y{0, 1, kHeight - kBottom, kTop};
  fit(c, x, y);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"white\"/>\n",
      kWidth, kHeight);
  svg += grid(x, true) + grid(y, false);
  for (std::size_t m = c.methods.size(); m-- > 0;) svg += line_of(c, m, x, y);
  svg += legend(c);
  svg += text_at(kLeft, 20, "start", title, " font-size=\"14\"");
  svg += text_at((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle",
                 "largest deviation, either way, mean edges");
  svg += text_at(
      0, 0, "middle", "total curvature, rad",
      fmt::format(" transform=\"translate(14 {}) rotate(-90)\"", (kTop + kHeight - kBottom) / 2));
  return svg + "</svg>\n";
}

}  // namespace talweg::driver

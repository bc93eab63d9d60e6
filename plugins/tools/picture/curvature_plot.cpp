#include "tools/picture/curvature_plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"
#include "tools/picture/caption.hpp"
#include "tools/picture/strokes.hpp"

namespace talweg::picture {
namespace {

constexpr double kDegree = 180 / std::numbers::pi;
constexpr double kLetters = 9;  // pixels, as captions of small panels
constexpr Color kText{0.2, 0.2, 0.22}, kGrid{0.87, 0.87, 0.86}, kAxis{0.62, 0.62, 0.62},
    kPaper{1, 1, 1}, kShade{0.93, 0.93, 0.91};

/// A step of 1, 2 or 5 times a power of ten, so that at most `most` steps fit into the range.
double tick_step(double range, int most) {
  const double least = range / most, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= least * (1 - 1e-9)) return step * power;
  }
  return 10 * power;
}

double largest(const PlotLine& line) {
  double most = 0;
  for (const CurvatureStep& step : line.steps) most = std::max(most, std::abs(step.curvature));
  return most;
}

/// The place of the axes, and their units.
class Frame {
 public:
  Frame(const CurvaturePlot& plot, std::size_t width, std::size_t height)
      : right_(double(width) - 18), bottom_(double(height) - 44), unit_(kDegree * plot.edge) {
    double behind = 0;
    for (const PlotLine& line : plot.lines) {
      (line.behind ? behind : range_) = std::max(line.behind ? behind : range_, largest(line));
    }
    range_ = 1.08 * unit_ * (range_ > 0 ? range_ : behind);
    if (!(range_ > 0)) range_ = 1;
  }

  [[nodiscard]] double x(double part) const { return left() + part * (right_ - left()); }
  /// The pixel of a value in degrees per h0; values out of range end slightly outside the frame.
  [[nodiscard]] double y(double value) const {
    const double bounded = std::clamp(value / range_, -1.1, 1.1);
    return 0.5 * (top() + bottom_) - 0.5 * bounded * (bottom_ - top());
  }
  [[nodiscard]] static double left() { return 62; }
  [[nodiscard]] static double top() { return 34; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] double bottom() const { return bottom_; }
  [[nodiscard]] double range() const { return range_; }  ///< degrees per h0
  [[nodiscard]] double unit() const { return unit_; }    ///< degrees per h0 of 1 rad per mesh unit

 private:
  double right_, bottom_, unit_, range_ = 0;
};

Light pale(const Color& color) { return 0.45 * to_linear(color) + 0.55 * to_linear(kPaper); }

Light light_of(const PlotLine& line) {
  return line.behind ? pale(line.color) : to_linear(line.color);
}

void draw_line(Image& image, const Frame& frame, const PlotLine& line) {
  if (line.steps.empty()) return;
  const double length = line.steps.back().to;
  std::vector<Spot> spots;
  for (const CurvatureStep& step : line.steps) {
    const double height = frame.y(frame.unit() * step.curvature);
    spots.push_back({frame.x(step.from / length), height});
    spots.push_back({frame.x(step.to / length), height});
  }
  draw_stroke(image, spots, 0.5 * line.width, light_of(line));
}

void draw_ground(Image& image, const Frame& frame, const CurvaturePlot& plot) {
  fill_box(image, {frame.left(), frame.top()}, {frame.right(), frame.bottom()}, to_linear(kPaper));
  for (const Stretch& part : plot.shown) {
    fill_box(image, {frame.x(part.from), frame.top()}, {frame.x(part.to), frame.bottom()},
             to_linear(kShade));
  }
  const double step = tick_step(frame.range(), 3);
  for (double value = 0; value <= frame.range(); value += step) {
    for (const double y : {frame.y(value), frame.y(-value)}) {
      draw_stroke(image, {{frame.left(), y}, {frame.right(), y}}, 0.5,
                  to_linear(value == 0 ? kAxis : kGrid));
    }
  }
}

/// Covers lines outside the frame, and draws its border.
void draw_margins(Image& image, const Frame& frame, const Color& background) {
  const Light light = to_linear(background);
  const auto width = double(image.width), height = double(image.height);
  fill_box(image, {0, 0}, {width, frame.top()}, light);
  fill_box(image, {0, frame.bottom()}, {width, height}, light);
  fill_box(image, {0, 0}, {frame.left(), height}, light);
  fill_box(image, {frame.right(), 0}, {width, height}, light);
  draw_stroke(image,
              {{frame.left(), frame.top()},
               {frame.right(), frame.top()},
               {frame.right(), frame.bottom()},
               {frame.left(), frame.bottom()},
               {frame.left(), frame.top()}},
              0.5, to_linear(kAxis));
}

/// Text that starts at `left`, or ends at `left` if it is aligned to the right.
void write(Image& image, const std::string& text, double left, double baseline,
           bool to_right = false) {
  const double half = 0.5 * caption_width(text, kLetters);
  draw_caption(image, text, to_right ? left - half : left + half, baseline, kLetters,
               to_linear(kText));
}

void label_axes(Image& image, const Frame& frame) {
  const double step = tick_step(frame.range(), 3);
  for (double value = 0; value <= frame.range(); value += step) {
    const std::string text = fmt::format("{:.6g}", value);
    write(image, text, frame.left() - 8, frame.y(value) + 0.5 * kLetters, true);
    if (value == 0) continue;
    write(image, "-" + text, frame.left() - 8, frame.y(-value) + 0.5 * kLetters, true);
  }
  for (int percent = 0; percent <= 100; percent += 20) {
    const double x = frame.x(percent / 100.0), y = frame.bottom();
    draw_stroke(image, {{x, y}, {x, y + 4}}, 0.5, to_linear(kAxis));
    draw_caption(image, std::to_string(percent), x, y + 8 + kLetters, kLetters, to_linear(kText));
  }
  write(image, "curvature (degrees per edge length)", frame.left(), frame.top() - 11);
  draw_caption(image, "along the curve (% of its length)", frame.x(0.5),
               frame.bottom() + 25 + kLetters, kLetters, to_linear(kText));
}

void draw_legend(Image& image, const Frame& frame, const std::vector<PlotLine>& lines) {
  constexpr double kSwatch = 22, kGap = 8;
  double right = frame.right();
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    const double baseline = frame.top() - 11, middle = baseline - 0.5 * kLetters;
    write(image, line->name, right, baseline, true);
    right -= caption_width(line->name, kLetters) + kGap;
    draw_stroke(image, {{right - kSwatch, middle}, {right, middle}}, 0.5 * line->width + 0.4,
                light_of(*line));
    right -= kSwatch + 3 * kGap;
  }
}

void check(const CurvaturePlot& plot, std::size_t width, std::size_t height) {
  if (width < 160 || width > 16384 || height < 100 || height > 8192) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("A plot of {} x {} pixels is smaller than 160 x 100 or larger than "
                            "16384 x 8192.",
                            width, height));
  }
  const bool any = std::any_of(plot.lines.begin(), plot.lines.end(),
                               [](const PlotLine& line) { return !line.steps.empty(); });
  if (!(plot.edge > 0) || !any) {
    throw Error(ErrorCode::kBadUsage, "A plot of curvature needs an edge length and a curve.");
  }
}

}  // namespace

std::vector<Stretch> stretches_in(const PictureCurve& curve, const Point& center, double radius) {
  std::vector<Stretch> result;
  double length = 0;
  bool inside = false;
  const std::size_t n = curve.points.size(),
                    segments = curve.closed ? n : std::max<std::size_t>(n, 1) - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const Point &a = curve.points[i], &b = curve.points[(i + 1) % n];
    const bool in = (0.5 * (a + b) - center).norm() < radius;
    if (in && !inside) result.push_back({length, length});
    length += (b - a).norm();
    if (in) result.back().to = length;
    inside = in;
  }
  for (Stretch& part : result) part = {part.from / length, part.to / length};
  return result;
}

Image draw_curvature(const CurvaturePlot& plot, std::size_t width, std::size_t height,
                     const Color& background) {
  check(plot, width, height);
  Image image;
  image.width = width;
  image.height = height;
  image.rgb.resize(3 * width * height);
  const Frame frame(plot, width, height);
  draw_ground(image, frame, plot);
  for (const PlotLine& line : plot.lines) draw_line(image, frame, line);
  draw_margins(image, frame, background);
  label_axes(image, frame);
  draw_legend(image, frame, plot.lines);
  return image;
}

}  // namespace talweg::picture

#include "tools/picture/caption.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace talweg::picture {
namespace {

struct Glyph {
  char letter;
  std::string_view strokes;
};

// Polylines through grid points "xy", separated by spaces. The baseline is y = 2, capitals reach
// y = 8, small letters y = 6, descenders y = 0.
constexpr auto kGlyphs = std::to_array<Glyph>({
    {'A', "022842 1434"},
    {'B', "02083847463505 3544433212 1202"},
    {'C', "4738180703123243"},
    {'D', "02082846443202"},
    {'E', "48080242 0535"},
    {'F', "480802 0535"},
    {'G', "473818070312324345 4525"},
    {'H', "0208 4248 0545"},
    {'I', "1232 2228 1838"},
    {'J', "4843321203"},
    {'K', "0208 4804 1542"},
    {'L', "080242"},
    {'M', "0208254842"},
    {'N', "02084248"},
    {'O', "180703123243473818"},
    {'P', "02083847463505"},
    {'Q', "180703123243473818 2442"},
    {'R', "02083847463505 2542"},
    {'S', "473818070615354443321203"},
    {'T', "0848 2822"},
    {'U', "080312324348"},
    {'V', "082248"},
    {'W', "0812253248"},
    {'X', "0248 0842"},
    {'Y', "082548 2522"},
    {'Z', "08480242"},
    {'a', "0516364542 4414031232 3243"},
    {'b', "0802 0516364543321203"},
    {'c', "4536160503123243"},
    {'d', "4842 4536160503123243"},
    {'e', "04444536160503123243"},
    {'f', "4738282722 1636"},
    {'g', "4641301001 4536160503123243"},
    {'h', "0802 0516364542"},
    {'i', "2622 2828"},
    {'j', "3631201001 3838"},
    {'k', "0802 4604 1542"},
    {'l', "282332"},
    {'m', "0206 05162522 25364542"},
    {'n', "0206 0516364542"},
    {'o', "160503123243453616"},
    {'p', "0006 0516364543321203"},
    {'q', "4046 4536160503123243"},
    {'r', "0206 04163645"},
    {'s', "45361605143443321203"},
    {'t', "282332 1636"},
    {'u', "0603123243 4642"},
    {'v', "062246"},
    {'w', "0612243246"},
    {'x', "0246 0642"},
    {'y', "0622 4610"},
    {'z', "06460242"},
    {'0', "180703123243473818"},
    {'1', "072822 1232"},
    {'2', "07183847460242"},
    {'3', "0718384746354443321203 1535"},
    {'4', "32380444"},
    {'5', "480805354443321203"},
    {'6', "4738180703123243443504"},
    {'7', "084822"},
    {'8', "15060718384746354443321203041535"},
    {'9', "031232434738180706154546"},
    {'.', "2222"},
    {',', "2211"},
    {':', "2222 2525"},
    {'-', "1535"},
    {'+', "0545 2723"},
    {'=', "0444 0646"},
    {'/', "0248"},
    {'(', "38272332"},
    {')', "18272312"},
    {'%', "0248 0808 4242"},
});

using Corner = std::array<double, 2>;

std::vector<std::vector<Corner>> strokes_of(char letter) {
  std::vector<std::vector<Corner>> strokes;
  const auto glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(),
                                  [&](const Glyph& g) { return g.letter == letter; });
  if (glyph == kGlyphs.end()) return strokes;
  std::vector<Corner> stroke;
  const std::string_view text = glyph->strokes;
  for (std::size_t i = 0; i <= text.size();) {
    if (i == text.size() || text[i] == ' ') {
      if (!stroke.empty()) strokes.push_back(stroke);
      stroke.clear();
      ++i;
      continue;
    }
    stroke.push_back({double(text[i] - '0'), double(text[i + 1] - '0')});
    i += 2;
  }
  return strokes;
}

void blend(std::uint8_t* rgb, const Light& color, double coverage) {
  const Light below = to_linear({rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0});
  store((1 - coverage) * below + coverage * color, rgb);
}

void draw_stroke(Image& image, const Corner& a, const Corner& b, double radius,
                 const Light& color) {
  const auto bounded = [](double value, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  const double reach = radius + 1;
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const std::size_t x_end = bounded(std::max(a[0], b[0]) + reach + 1, image.width);
  const std::size_t y_end = bounded(std::max(a[1], b[1]) + reach + 1, image.height);
  for (std::size_t y = bounded(std::min(a[1], b[1]) - reach, image.height); y < y_end; ++y) {
    for (std::size_t x = bounded(std::min(a[0], b[0]) - reach, image.width); x < x_end; ++x) {
      const double px = double(x) + 0.5 - a[0], py = double(y) + 0.5 - a[1];
      const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
      const double distance = std::hypot(px - t * dx, py - t * dy);
      const double coverage = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
      if (coverage > 0) blend(image.pixel(x, y), color, coverage);
    }
  }
}

}  // namespace

void draw_caption(Image& image, const std::string& text, double center_x, double baseline,
                  double height, const Light& color) {
  const double unit = height / 6, advance = 5.6 * unit;
  const double left = center_x - 0.5 * (advance * double(text.size()) - 1.6 * unit);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto place = [&](const Corner& c) -> Corner {
      return {left + advance * double(i) + unit * c[0], baseline - unit * (c[1] - 2)};
    };
    for (const std::vector<Corner>& stroke : strokes_of(text[i])) {
      for (std::size_t k = 0; k + 1 < stroke.size(); ++k) {
        draw_stroke(image, place(stroke[k]), place(stroke[k + 1]), 0.085 * height, color);
      }
    }
  }
}

}  // namespace talweg::picture

#include "tools/picture/caption.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "tools/picture/strokes.hpp"

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

std::vector<std::vector<Spot>> strokes_of(char letter) {
  std::vector<std::vector<Spot>> strokes;
  const auto glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(),
                                  [&](const Glyph& g) { return g.letter == letter; });
  if (glyph == kGlyphs.end()) return strokes;
  std::vector<Spot> stroke;
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

}  // namespace

void draw_caption(Image& image, const std::string& text, double center_x, double baseline,
                  double height, const Light& color) {
  const double unit = height / 6, advance = 5.6 * unit;
  const double left = center_x - 0.5 * caption_width(text, height);
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (std::vector<Spot>& stroke : strokes_of(text[i])) {
      for (Spot& s : stroke) {
        s = {left + advance * double(i) + unit * s[0], baseline - unit * (s[1] - 2)};
      }
      draw_stroke(image, stroke, 0.085 * height, color);
    }
  }
}

double caption_width(const std::string& text, double height) {
  return (5.6 * double(text.size()) - 1.6) * height / 6;
}

}  // namespace talweg::picture

#include "tools/picture/contact_sheet.hpp"

#include <algorithm>

namespace talweg::picture {

Image contact_sheet(const std::vector<Image>& pictures, std::size_t columns) {
  constexpr std::size_t kGap = 3;
  Image sheet;
  if (pictures.empty()) return sheet;
  const std::size_t width = pictures[0].width, height = pictures[0].height;
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  columns = std::min(columns, pictures.size());
  sheet.width = columns * (width + kGap) - kGap;
  sheet.height = rows * (height + kGap) - kGap;
  sheet.rgb.assign(3 * sheet.width * sheet.height, 255);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t left = i % columns * (width + kGap), top = i / columns * (height + kGap);
    for (std::size_t y = 0; y < height; ++y) {
      std::copy_n(pictures[i].pixel(0, y), 3 * width, sheet.pixel(left, top + y));
    }
  }
  return sheet;
}

Image stacked(const Image& top, const Image& bottom) {
  Image both;
  both.width = std::max(top.width, bottom.width);
  both.height = top.height + bottom.height;
  both.rgb.assign(3 * both.width * both.height, 255);
  std::size_t row = 0;
  for (const Image* image : {&top, &bottom}) {
    for (std::size_t y = 0; y < image->height; ++y, ++row) {
      std::copy_n(image->pixel(0, y), 3 * image->width, both.pixel(0, row));
    }
  }
  return both;
}

}  // namespace talweg::picture

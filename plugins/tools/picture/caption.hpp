// Short texts in a picture.
#pragma once

#include <string>

#include "tools/picture/image.hpp"
#include "tools/picture/shading.hpp"

namespace talweg::picture {

/// Writes a line of text in thin strokes, centred at pixel `center_x`, with capitals `height`
/// pixels high standing on `baseline`. Letters, digits and common punctuation; other characters are
/// left blank.
void draw_caption(Image& image, const std::string& text, double center_x, double baseline,
                  double height, const Light& color);

/// The width of the caption, pixels.
double caption_width(const std::string& text, double height);

}  // namespace talweg::picture

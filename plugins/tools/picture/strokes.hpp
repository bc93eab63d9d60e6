// Draws polylines into a picture.
#pragma once

#include <array>
#include <vector>

#include "tools/picture/image.hpp"
#include "tools/picture/shading.hpp"

namespace talweg::picture {

/// x to the right and y down, pixels; a pixel's centre is at 0.5.
using Spot = std::array<double, 2>;

/// Draws the polyline through these spots with smooth borders and round ends. A pixel that it
/// passes several times is covered as by a single pass. O(pixels around each piece).
void draw_stroke(Image& image, const std::vector<Spot>& spots, double radius, const Light& color);

/// Fills the pixels of [left, right) x [top, bottom), as far as they are in the picture.
void fill_box(Image& image, const Spot& top_left, const Spot& bottom_right, const Light& color);

}  // namespace talweg::picture

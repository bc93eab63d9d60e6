// Joins several pictures to one.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/picture/image.hpp"

namespace talweg::picture {

/// Pictures of one size, row by row, `columns` in a row (the last row may be shorter).
Image contact_sheet(const std::vector<Image>& pictures, std::size_t columns);

/// One picture below another; the narrower one is filled up with white.
Image stacked(const Image& top, const Image& bottom);

}  // namespace talweg::picture

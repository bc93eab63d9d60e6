// A contact sheet is several pictures in one.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/picture/image.hpp"

namespace talweg::picture {

/// Pictures of one size, row by row, `columns` in a row (the last row may be shorter).
Image contact_sheet(const std::vector<Image>& pictures, std::size_t columns);

}  // namespace talweg::picture

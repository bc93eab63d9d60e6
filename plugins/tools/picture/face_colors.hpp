// Colours of faces for labels and pieces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/picture/render.hpp"

namespace talweg::picture {

/// A soft colour for each label, equal for equal labels in every picture.
std::vector<Color> label_colors(const std::vector<std::int64_t>& labels);

/// Whole numbers, separated by blanks or ends of lines. Throws Error(kBadFile) for anything else.
std::vector<std::int64_t> read_label_file(const std::string& path);

/// For each face its connected piece, numbered by size, the largest 0. O(faces).
std::vector<std::int64_t> pieces_of(const MeshLists& mesh);

/// Moves all pieces but the largest.
void move_apart(MeshLists& mesh, const Point& by);

}  // namespace talweg::picture

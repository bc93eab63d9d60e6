// Seam pieces are the single pieces of meshes that were taken apart.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/cutting/seam_opening.hpp"

namespace talweg::test {

inline Piece piece(const OpenedSeams& opened, std::size_t number) {
  std::vector<bool> wanted(opened.pieces, false);
  wanted[number] = true;
  return piece_of(opened, wanted);
}

}  // namespace talweg::test

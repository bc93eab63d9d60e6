// Face items are pieces of curves, laid out in the face that they share.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

/// A segment or a point (a == b) of a curve.
struct FaceItem {
  const PolylinePiece* piece;
  PlanePoint a, b;
  double length = 0;
};

/// Calls visit(i, k) with pairs of items of one face that may come within `same` (mesh units) of
/// each other: with so many that every connected part of what items have in common is found, but
/// for corners of the face that items end at. Equal items are a chain of pairs, of which one stands
/// for all of them. Of items that end at one corner, each is paired with the next longer ones on
/// either side of it, which contain it if any do.
/// O(n log n) and what meets away from corners.
void visit_item_pairs(std::span<const FaceItem> items, double same,
                      const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace talweg

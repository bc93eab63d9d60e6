// Face items are pieces of curves in one face, laid out in the plane.
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
/// each other. The pairs suffice to find every connected contact of items, except contacts at
/// corners of the face where items end. A group of equal items is visited as a chain of pairs, and
/// one item stands for the group in other pairs. An item that ends at a corner is paired, among the
/// items at this corner, with the nearest longer items on either side, which contain the item if
/// any item does. O(n log n + pairs away from corners).
void visit_item_pairs(std::span<const FaceItem> items, double same,
                      const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace talweg

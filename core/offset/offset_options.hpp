// The options of an offset are its distances, and which parts of them are wanted.
#pragma once

#include <optional>
#include <vector>

namespace talweg {

/// On which side of a curve something lies, seen along the curve from outside the mesh.
enum class CurveSide { kBoth, kLeft, kRight };
const char* to_string(CurveSide side);  ///< "both", "left", "right"

/// What an offset does at the ends of open curves.
enum class OffsetCaps {
  kRound,  ///< it goes around them
  kNone,   ///< it is cut off where the way to the curve leads to its end
};

struct OffsetOptions {
  std::vector<double> distances;      ///< mesh units, > 0, at least one
  CurveSide side = CurveSide::kBoth;  ///< on one side there are never caps
  OffsetCaps caps = OffsetCaps::kRound;
  /// Mesh units, > 0: how far the distance may be off between two points of a result. By default a
  /// thousandth of the distance or a fiftieth of the mean edge, whichever is less.
  std::optional<double> tolerance;

  void validate() const;  ///< throws Error(kBadUsage) naming the field and its bound
};

}  // namespace talweg

#include "talweg/core/offset/offset_options.hpp"

#include <cmath>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

const char* to_string(CurveSide side) {
  switch (side) {
    case CurveSide::kLeft:
      return "left";
    case CurveSide::kRight:
      return "right";
    case CurveSide::kBoth:
      break;
  }
  return "both";
}

void OffsetOptions::validate() const {
  if (distances.empty()) throw Error(ErrorCode::kBadUsage, "An offset needs a distance.");
  for (const double distance : distances) {
    if (!(distance > 0 && std::isfinite(distance))) {
      throw Error(
          ErrorCode::kBadUsage,
          fmt::format("The distance of an offset must be finite and > 0, not {}.", distance));
    }
  }
  if (tolerance && !(*tolerance > 0 && std::isfinite(*tolerance))) {
    throw Error(ErrorCode::kBadUsage, "tolerance must be finite and > 0.");
  }
}

}  // namespace talweg

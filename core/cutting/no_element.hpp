// The numbers that stand for no element, as the origin of what lies in lids.
#pragma once

#include <cstdint>

namespace talweg {

inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;

}  // namespace talweg

// Which coordinates can be worked with.
#pragma once

#include "talweg/core/mesh_lists.hpp"

namespace talweg {

/// Finite, and so that squares do not overflow.
inline bool can_be_measured(const Point& p) { return (p.array().abs() <= 1e152).all(); }

}  // namespace talweg

// Smooth random functions of space.
#pragma once

#include <cstdint>

#include "talweg/core/mesh_lists.hpp"

namespace talweg::scenes {

/// Value noise: random values in [-1, 1] at integer points, joined smoothly (C²).
double noise(const Point& p, std::uint64_t seed);

/// `octaves` layers of noise, each twice as fine and half as strong; in about [-1, 1].
double fractal_noise(const Point& p, int octaves, std::uint64_t seed);

}  // namespace talweg::scenes

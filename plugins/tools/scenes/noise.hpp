// A smooth random function of space.
#pragma once

#include <cstdint>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::scenes {

/// Gradient noise (Perlin 2002): zero with a random slope at integer points, joined smoothly (C²);
/// mostly within [-1, 1].
double noise(const Point& p, std::uint64_t seed);

/// `octaves` layers of noise, each twice as fine and half as strong; in about [-1, 1].
double fractal_noise(const Point& p, int octaves, std::uint64_t seed);

}  // namespace talweg::scenes

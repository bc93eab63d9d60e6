// Ambient occlusion puts soft shadows into valleys, from the z-buffer alone.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/picture/sample_buffer.hpp"

namespace talweg::picture {

/// The part of the surroundings, in [0, 1], that neighbours on the screen leave open; one value per
/// pixel of samples x samples samples. `reach` is the radius of the neighbourhood, pixels.
/// O(pixels).
std::vector<float> openness(const SampleBuffer& buffer, std::size_t samples, double reach);

}  // namespace talweg::picture

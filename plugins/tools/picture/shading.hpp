// Shades surfaces and tubes.
#pragma once

#include <Eigen/Core>

#include "tools/picture/render.hpp"

namespace talweg::picture {

/// Linear light per channel.
using Light = Eigen::Array3d;

Light to_linear(const Color& color);
/// Writes 8-bit sRGB; values are clamped to [0, 1].
void store(const Light& light, std::uint8_t* rgb);

/// The light that a surface with this unit normal (in camera axes: right, up, to the viewer) sends
/// to the viewer; `openness` in [0, 1] is the part of the surroundings that is not hidden. Normals
/// that point away from the viewer show the inside, in a cooler and darker tone.
Light shade_surface(const Light& material, const Eigen::Vector3d& normal, double openness);

/// The light from a tube; `facing` in [0, 1] is its normal's part towards the viewer.
Light shade_tube(const Light& color, double facing);

}  // namespace talweg::picture

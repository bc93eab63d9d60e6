// Colours by which the curves of a drawing differ, in the scene and in the panel's list.
#pragma once

#include <array>
#include <cstdint>

#include <ACG/Math/VectorT.hh>

namespace talweg::openflipper {

/// The colour of the smoothed curve with this number, from 1; colours repeat after eight curves.
inline ACG::Vec4f colour_of_curve(std::uint32_t number) {
  static const std::array<ACG::Vec4f, 8> kColours = {
      ACG::Vec4f(0.15f, 1.0f, 0.35f, 1.0f),  ACG::Vec4f(0.25f, 0.75f, 1.0f, 1.0f),
      ACG::Vec4f(1.0f, 0.6f, 0.15f, 1.0f),   ACG::Vec4f(1.0f, 0.45f, 0.85f, 1.0f),
      ACG::Vec4f(0.95f, 0.95f, 0.25f, 1.0f), ACG::Vec4f(0.7f, 0.6f, 1.0f, 1.0f),
      ACG::Vec4f(0.2f, 0.95f, 0.9f, 1.0f),   ACG::Vec4f(1.0f, 0.75f, 0.65f, 1.0f)};
  return kColours[(number + kColours.size() - 1) % kColours.size()];
}

/// The colour of the drawn curve: darker, so that drawing and result differ where they are close.
inline ACG::Vec4f colour_of_drawn(std::uint32_t number) {
  const ACG::Vec4f result = colour_of_curve(number);
  return {0.25f * result[0], 0.25f * result[1], 0.25f * result[2], 1.0f};
}

}  // namespace talweg::openflipper

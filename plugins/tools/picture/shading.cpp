#include "tools/picture/shading.hpp"

#include <algorithm>
#include <cmath>

namespace talweg::picture {

Light to_linear(const Color& color) {
  Light result;
  for (int k = 0; k < 3; ++k) {
    const double c = color[static_cast<std::size_t>(k)];
    result[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return result;
}

void store(const Light& light, std::uint8_t* rgb) {
  for (int k = 0; k < 3; ++k) {
    const double c = std::clamp(light[k], 0.0, 1.0);
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    rgb[k] = static_cast<std::uint8_t>(std::lround(255 * s));
  }
}

Light shade_surface(const Light& material, const Eigen::Vector3d& normal, double openness) {
  const bool inside = normal.z() < 0;
  const Eigen::Vector3d n = inside ? Eigen::Vector3d(-normal) : normal;
  static const Eigen::Vector3d key = Eigen::Vector3d(-0.45, 0.65, 0.70).normalized();
  static const Eigen::Vector3d fill = Eigen::Vector3d(0.80, 0.05, 0.55).normalized();
  static const Eigen::Vector3d halfway = (key + Eigen::Vector3d::UnitZ()).normalized();
  static const Light key_color(0.86, 0.83, 0.77), fill_color(0.13, 0.15, 0.20);
  static const Light sky(0.36, 0.37, 0.40), ground(0.24, 0.21, 0.19);

  // Wrapped diffuse light keeps the shadow side soft.
  const double wrapped = std::max(0.0, (n.dot(key) + 0.25) / 1.25);
  const double up = 0.5 + 0.5 * n.y();
  const Light around = openness * (up * sky + (1 - up) * ground);
  const double direct = 0.5 + 0.5 * openness;
  Light light =
      material *
      (around + direct * (wrapped * wrapped * key_color + std::max(0.0, n.dot(fill)) * fill_color));
  if (inside) return light * Light(0.50, 0.50, 0.56);
  light += 0.07 * direct * std::pow(std::max(0.0, n.dot(halfway)), 28.0);
  const double edge = 1 - n.z();
  return light * (1 - 0.25 * edge * edge * edge);
}

Light shade_tube(const Light& color, double facing) {
  return color * (0.62 + 0.38 * facing) + 0.03 * std::pow(facing, 6.0);
}

}  // namespace talweg::picture

#include "tools/scenes/noise.hpp"

#include <array>
#include <cmath>

#include "tools/scenes/random.hpp"

namespace talweg::scenes {
namespace {

// The product of a random vector at the lattice point with d.
double lattice_slope(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed,
                     const Point& d) {
  std::uint64_t h = mix_bits(seed ^ static_cast<std::uint64_t>(x));
  h = mix_bits(h ^ static_cast<std::uint64_t>(y));
  h = mix_bits(h ^ static_cast<std::uint64_t>(z));
  const auto component = [&](unsigned shift) {
    return static_cast<double>((h >> shift) & 0xFFFFU) * 0x1p-15 - 1;
  };
  return component(0) * d.x() + component(16) * d.y() + component(32) * d.z();
}

double eased(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

}  // namespace

double noise(const Point& p, std::uint64_t seed) {
  const Point base = p.array().floor();
  const std::array<double, 3> t{eased(p.x() - base.x()), eased(p.y() - base.y()),
                                eased(p.z() - base.z())};
  const auto x = static_cast<std::int64_t>(base.x()), y = static_cast<std::int64_t>(base.y()),
             z = static_cast<std::int64_t>(base.z());
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
    const double weight = (i ? t[0] : 1 - t[0]) * (j ? t[1] : 1 - t[1]) * (k ? t[2] : 1 - t[2]);
    const Point d = p - base - Point(i, j, k);
    sum += weight * lattice_slope(x + i, y + j, z + k, seed, d);
  }
  return 1.5 * sum;
}

double fractal_noise(const Point& p, int octaves, std::uint64_t seed) {
  double sum = 0, strength = 0.6;
  Point q = p;
  for (int k = 0; k < octaves; ++k) {
    sum += strength * noise(q, seed + static_cast<std::uint64_t>(k));
    q = 2.03 * q + Point(0.37, 0.71, 0.13);
    strength *= 0.5;
  }
  return sum;
}

}  // namespace talweg::scenes

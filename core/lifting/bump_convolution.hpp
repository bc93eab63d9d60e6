// A bump convolution smooths a distance with a bump function (equation 3 of the paper).
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

struct BumpOptions {
  double radius = 0;  ///< mesh units: support of the bump; 0 leaves the values unchanged
  int rays = 32;      ///< number of directions about each vertex; even
  int samples = 12;   ///< along each ray

  /// Throws Error(kBadUsage) naming the field and its bound: radius finite and >= 0, rays even
  /// from 4 to 1024, samples from 2 to 64.
  void validate() const;
};

/// The weighted mean of a piecewise linear function around every vertex. The weight is the bump
/// h(r) = exp(-1 / (1 - (r/R)²)), r < R, of the distance r along the surface:
///
///   result(x) = ∫ h(dist(x, y)) value(y) dA / ∫ h(dist(x, y)) dA.
///
/// The integral is taken in polar coordinates about x: `rays` straightest rays that divide the cone
/// angle evenly, traced over the triangles from edge lengths, with `samples` Gauss-Legendre radii
/// on each. A ray that meets a vertex passes it on one side. A ray that meets the boundary ends
/// there, and the remaining weights are normalised. A ray also ends after 1000 triangles plus eight
/// times the face count, or after 65,536 triangles if that is fewer.
///
/// Constants stay unchanged everywhere, bit for bit. Linear functions on a plane stay unchanged up
/// to rounding at vertices farther than R from the boundary, because the rays come in opposite
/// pairs. The result is a weighted mean of values within R, so a function of Lipschitz constant c
/// changes by at most c·R. Where rays cross behind a tip, each of them counts the surface there.
///
/// `values` has one entry per vertex. +infinity (a component that the curve does not reach) stays,
/// and rays end where they meet one. Isolated vertices keep their value. Cost: vertices · rays ·
/// (samples + 1 + R / mean edge length), where R counts at most as the length of such a ray. Uses
/// no memory besides the result.
///
/// Throws Error(kBadUsage) when the options are invalid, the number of values is not the number of
/// vertices, or a value is NaN or -infinity; Cancelled when `progress` (stage "solve") returns
/// false.
std::vector<double> convolve_with_bump(const Surface& surface, std::span<const double> values,
                                       const BumpOptions& options, const Progress& progress = {});

}  // namespace talweg

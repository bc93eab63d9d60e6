// A bump convolution smooths a distance with a bump function (equation 3 of the paper).
#pragma once

#include <span>
#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

struct BumpOptions {
  double radius = 0;  ///< mesh units: support of the bump; 0 leaves the values as they are
  int rays = 32;      ///< directions about each vertex; even
  int samples = 12;   ///< along each ray

  /// Throws Error(kBadUsage) naming the field and its bound: radius finite and >= 0, rays even
  /// from 4 to 1024, samples from 2 to 64.
  void validate() const;
};

/// The mean of a piecewise linear function around every vertex, weighted with the bump
/// h(r) = exp(-1 / (1 - (r/R)²)), r < R, of the distance r along the surface:
///
///   result(x) = ∫ h(dist(x, y)) value(y) dA / ∫ h(dist(x, y)) dA.
///
/// The integral is taken in polar coordinates about x: `rays` straightest rays that divide the
/// cone angle evenly, traced over the triangles from edge lengths, with `samples` Gauss-Legendre
/// radii on each. A ray that meets a vertex passes it on one side. A ray that meets the boundary
/// ends there, and the weights that are left are normalised; so does one that has gone through 1000
/// triangles and eight times as many as there are, or through 65,536.
///
/// Constants come out unchanged everywhere, bit for bit. Linear functions on a plane come out
/// unchanged up to rounding at vertices farther than R from the boundary, since the rays come in
/// opposite pairs. The result is a weighted mean of values within R, so a function of Lipschitz
/// constant c changes by at most c·R. Where rays have crossed behind a tip they count the surface
/// there once for each ray.
///
/// `values` has one entry per vertex. +infinity (a component that the curve does not reach) stays,
/// and rays end where they meet one. Isolated vertices keep their value.
/// Cost: vertices · rays · (samples + 1 + R / mean edge length), R at most the length of such rays.
/// No memory but the result.
///
/// Throws Error(kBadUsage) when the options are invalid, the number of values is not the number of
/// vertices, or a value is NaN or -infinity; Cancelled when `progress` (stage "solve") says so.
std::vector<double> convolve_with_bump(const Surface& surface, std::span<const double> values,
                                       const BumpOptions& options, const Progress& progress = {});

}  // namespace talweg

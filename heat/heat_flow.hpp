// The heat flow is the heat after one implicit time step, at any distance from its source.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/heat_triangles.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// A field of huge range: entry i is value[i] · 2^(-kStageBits · stage[i]).
struct ScaledField {
  static constexpr int kStageBits = 800;
  std::vector<double> value;
  std::vector<std::int32_t> stage;
};

/// Solves (M / h² + s S) u = source, the heat flow of time s h² (Crane, Weischedel & Wardetzky
/// 2013, step I), with `factor` the factor of the matrix M / h² + s S (or of this matrix with
/// Dirichlet rows).
///
/// u falls by a factor of about exp(-1 / √s) per edge, so doubles underflow after some 2,000 edges.
/// Where |u| is below 2^-800 the equation is therefore solved again, scaled. Let A be the vertices
/// known so far. The rest of u then solves the system with the same matrix and another source: -(s
/// S u_A) at vertices outside A, and +(s S u_rest) at the rim of A. The result is u itself, not an
/// approximation, to a few digits less than a single solve. One more solve is needed for each 1,700
/// edge lengths or so.
///
/// `source` has one entry per vertex, of order 1 at most; `reached[i]` is 0 where u is 0 by
/// definition: in components without a source and at Dirichlet rows. `progress` (stage "solve") is
/// called before each solve; Cancelled is thrown when it returns false.
ScaledField heat_flow(const CholeskyFactor& factor, std::span<const HeatTriangle> triangles,
                      double time_scale, const std::vector<double>& source,
                      const std::vector<char>& reached, const Progress& progress = {});

/// (a + b) / 2 where `where` is set, else a. b must not exceed a by more than 2^kStageBits.
ScaledField average(ScaledField a, const ScaledField& b, const std::vector<char>& where);

}  // namespace talweg

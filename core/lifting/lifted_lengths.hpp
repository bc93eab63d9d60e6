// A lifted length is the length of an edge in the surface that a potential lifts.
#pragma once

#include <cmath>
#include <span>

#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// Equation 7 of the paper for a potential of any number of components: √(|p−q|² + |Φp−Φq|²). The
/// lifted sides of a triangle satisfy the triangle inequality for every Φ. O(components).
inline double lifted_length(double length, std::span<const double> at_p,
                            std::span<const double> at_q) {
  double squared = length * length;
  for (std::size_t k = 0; k < at_p.size(); ++k) {
    squared += (at_p[k] - at_q[k]) * (at_p[k] - at_q[k]);
  }
  return std::sqrt(squared);
}

inline double lifted_length(double length, double at_p, double at_q) {
  return std::sqrt(length * length + (at_p - at_q) * (at_p - at_q));
}

/// The metric without a lift, with the rounding of lifted lengths.
inline double unlifted_length(VertexId /*p*/, VertexId /*q*/, double length) {
  return lifted_length(length, 0.0, 0.0);
}

}  // namespace talweg

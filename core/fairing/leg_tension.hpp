// Legs are the stretches of a chain without a stroke; tension draws them straight.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"

namespace talweg {

/// The legs among the stretches of a chain, and their tension. A stretch leads from a fixed point
/// to the next; the last stretch of a closed chain leads to the first fixed point.
struct LegTension {
  /// c >= 0: legs minimise ∫κ² ds · length^c. The minimising curve does not change when one of its
  /// points becomes a fixed point, and does not depend on the unit of length.
  double length_exponent = 0;
  std::vector<bool> is_leg;        ///< per stretch; empty without legs
  std::vector<double> factors;     ///< per stretch: factor of its tension, >= 1
  std::vector<double> tolerances;  ///< per fixed point, mesh units
  /// The tension t, 1 / mesh units²; replaces the balanced tension c ∫κ² ds / length.
  std::optional<double> tension;

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool is_on_leg(const ChainJoin& join) const {
    return join.stretch < is_leg.size() && is_leg[join.stretch];
  }
  [[nodiscard]] double factor(const ChainJoin& join) const {
    return join.stretch < factors.size() ? factors[join.stretch] : 1;
  }
};

}  // namespace talweg

// Legs are the stretches of a chain that no stroke holds: they are drawn straight by tension.
#pragma once

#include <optional>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"

namespace talweg {

/// Which stretches of a chain are legs, and what pulls on them. A stretch leads from a fixed point
/// to the next; the last one of a closed chain leads to the first fixed point.
struct LegTension {
  /// c: legs minimise ∫κ² ds · (their length)^c. What is inserted on such a curve leaves it as it
  /// is, and it does not depend on the unit. 0 or more.
  double relative = 0;
  std::vector<bool> is_leg;        ///< per stretch; empty where none is
  std::vector<double> stronger;    ///< per stretch: factor of its tension, >= 1
  std::vector<double> tolerances;  ///< per fixed point, mesh units
  /// 1 / mesh units²; replaces c ∫κ² ds / length, at which it would balance.
  std::optional<double> tension;

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool is_on_leg(const ChainJoin& join) const {
    return join.stretch < is_leg.size() && is_leg[join.stretch];
  }
  [[nodiscard]] double factor(const ChainJoin& join) const {
    return join.stretch < stronger.size() ? stronger[join.stretch] : 1;
  }
};

}  // namespace talweg

#include "talweg/core/fairing/leg_tension.hpp"

#include <algorithm>

namespace talweg {

bool LegTension::any() const {
  return std::find(is_leg.begin(), is_leg.end(), true) != is_leg.end();
}

}  // namespace talweg

// Matrix checks refuse matrices whose faults no factorization would notice.
#pragma once

#include "talweg/heat/symmetric_matrix.hpp"

namespace talweg {

/// Throws Error(kNumerical) when a pattern is not as SymmetricMatrix demands.
void check_pattern(const SymmetricMatrix& matrix);

/// Throws Error(kNumerical) when an entry is not finite; the message names its column.
void check_values(const SymmetricMatrix& matrix);

}  // namespace talweg

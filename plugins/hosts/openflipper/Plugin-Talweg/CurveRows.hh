// Curve rows are what the panel says of each curve of a session.
#pragma once

#include "CurvesBox.hh"
#include "Session.hh"

namespace talweg::openflipper {

[[nodiscard]] CurvesState curves_state(const Session& session);
/// "Curve 3", or the name that a person gave.
[[nodiscard]] QString title_of(const editing::Curve& curve);

}  // namespace talweg::openflipper

// The rows of the panel's list of curves, from the curves of a session.
#pragma once

#include "CurvesBox.hh"
#include "Session.hh"

namespace talweg::openflipper {

[[nodiscard]] CurvesState curves_state(const Session& session);
/// "Curve 3", or the user's name for the curve.
[[nodiscard]] QString title_of(const editing::Curve& curve);

}  // namespace talweg::openflipper

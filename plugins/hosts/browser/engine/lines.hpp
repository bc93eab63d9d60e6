// Curves on the mesh for the page: `Line` in src/engine/types.ts.
#pragma once

#include "answer.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::browser {

/// The results of talweg.smooth with their reports. Turning is the mean geodesic curvature (1 /
/// mesh unit, positive to the left) within `window` on both sides of a point, since a polyline
/// turns only at its points.
Json lines_of(const host::Results& results, double window, Answer& answer);

/// Drawn curves, of which only the length is known.
Json drawn_lines(const std::vector<host::Curve>& curves, Answer& answer);

/// x, y and z of each row, one after the other.
std::vector<double> flat(const std::vector<std::array<double, 3>>& rows);

}  // namespace talweg::browser

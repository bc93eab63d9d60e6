// What was measured, as tables.
#pragma once

#include <span>
#include <string>

#include "quality/runs.hpp"

namespace talweg::quality {

/// Every run, as comma-separated values.
std::string csv(std::span<const Run> runs);

/// As Markdown. Drawings that turn by less than 25 rad do not count where curvature is compared.
std::string tables(std::span<const Run> runs);
std::string tables(std::span<const Sweep> sweeps);
std::string tables(std::span<const Subdivision> subdivisions);

}  // namespace talweg::quality

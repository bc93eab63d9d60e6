// Ridge options set how strongly, of which kind and from how far ridges attract a drawing.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "talweg/core/ridges/ridge_snapping.hpp"

namespace talweg::driver {

/// The options as typed.
struct RidgeChoice {
  double strength = 0;
  std::string kind = "both";
  std::optional<double> band;  ///< mesh units

  [[nodiscard]] RidgeOptions options() const { return {strength, ridge_kind(kind), band}; }
};

/// Adds --ridges, --ridge-kind and --ridge-band, with the help texts of talweg.smooth.
void add_ridge_options(CLI::App& app, RidgeChoice& choice);

}  // namespace talweg::driver

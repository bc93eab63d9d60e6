// What the panel and scripts call the parameters of a plugin.
#pragma once

#include <string>
#include <string_view>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// The property of a parameter: MaxDeviation for max_deviation. One filter has points of its own,
/// so points is DrawnPoints.
std::string property_name(std::string_view id);

/// What ParaView makes of that name for the panel: Max Deviation.
std::string panel_name(std::string_view id);

/// A sentence of a plugin with the panel's names of its parameters, where it names them by label
/// and id, "Largest deviation (max_deviation)", or by an id that is no English word: max_deviation.
std::string in_words_of_panel(std::string sentence, const talweg_plugin& plugin);

}  // namespace talweg::paraview

// The names of a plugin's parameters in the panel and in scripts.
#pragma once

#include <string>
#include <string_view>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// The property of a parameter: MaxDeviation for max_deviation. The parameter points is
/// DrawnPoints, since one filter has a property Points of its own.
std::string property_name(std::string_view id);

/// ParaView's label of the property in the panel: Max Deviation.
std::string panel_name(std::string_view id);

/// A sentence of a plugin with its parameters named as in the panel. The sentence may name a
/// parameter by label and id, "Largest deviation (max_deviation)", or by an id that is not an
/// English word: max_deviation.
std::string in_words_of_panel(std::string sentence, const talweg_plugin& plugin);

}  // namespace talweg::paraview

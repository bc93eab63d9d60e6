// Makes a property of ParaView's panel from the description of a plugin's parameter.
#pragma once

#include <string>
#include <string_view>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// The text with XML's special letters escaped.
std::string escaped(std::string_view text);

/// The property, named after the parameter's id (max_deviation: MaxDeviation); empty for kinds of a
/// later version of the interface. Properties for arrays use the domains "arrays" (of points) and
/// "cell_arrays" of the property Input. Throws std::runtime_error for a parameter that no property
/// can be made for.
std::string property_xml(const talweg_parameter& parameter);

}  // namespace talweg::paraview

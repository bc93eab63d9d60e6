// ParaView's property panel for talweg.smooth, made from the plugin's own description.
#pragma once

#include <string>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// Server-manager XML with two filters of the class vtkTalwegSmooth: TalwegSmoothCurve takes the
/// curve as its second input, TalwegSmoothPoints as clicked points or vertex numbers. Each has one
/// property for each parameter, named after its id (max_deviation: MaxDeviation).
/// Throws std::runtime_error for a parameter that no property can be made for.
std::string server_manager_xml(const talweg_plugin& plugin);

}  // namespace talweg::paraview

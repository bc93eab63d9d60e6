// ParaView's property panel for talweg.smooth is made from the plugin's own description.
#pragma once

#include <string>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// Server-manager XML with three filters of the class vtkTalwegSmooth, by what the drawing is:
/// TalwegSmoothCurve takes it as its second input, TalwegSmoothPoints as points that are clicked,
/// TalwegSmoothVertices as numbers of vertices. Each has one property for each parameter, named
/// after its id (max_deviation: MaxDeviation).
/// Throws std::runtime_error for a parameter that no property can be made for.
std::string server_manager_xml(const talweg_plugin& plugin);

}  // namespace talweg::paraview

// ParaView's property panels are made from the plugins' own descriptions.
#pragma once

#include <functional>
#include <string>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// Throws if there is no plugin with this id.
using FindPlugin = std::function<const talweg_plugin&(const char* id)>;

/// Server-manager XML. Three filters are of the class vtkTalwegSmooth, by what the drawing is:
/// TalwegSmoothCurve takes it as its second input, TalwegSmoothPoints as points that are clicked,
/// TalwegSmoothVertices as numbers of vertices. Others are TalwegCut, TalwegLabelBorders,
/// TalwegRepair, TalwegMeasure and TalwegOffset. Each has one property for each parameter of its
/// plugin.
/// Without `own_widgets` points are clicked with ParaView's widget for polylines.
/// Throws what `plugin_named` and property_xml() do.
std::string server_manager_xml(const FindPlugin& plugin_named, bool own_widgets);

}  // namespace talweg::paraview

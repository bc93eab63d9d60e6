// Makes ParaView's property panels from the plugins' descriptions.
#pragma once

#include <functional>
#include <string>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// Throws if there is no plugin with this id.
using FindPlugin = std::function<const talweg_plugin&(const char* id)>;

/// Server-manager XML. Three filters are of the class vtkTalwegSmooth and differ in the form of the
/// drawing: TalwegSmoothCurve takes its second input, TalwegSmoothPoints clicked points,
/// TalwegSmoothVertices vertex indices. Other filters are TalwegCut, TalwegLabelBorders,
/// TalwegRepair, TalwegMeasure and TalwegOffset. A filter has a property for each parameter of its
/// plugin. Without `own_widgets` points are clicked with ParaView's widget for polylines. Throws
/// the exceptions of `plugin_named` and property_xml().
std::string server_manager_xml(const FindPlugin& plugin_named, bool own_widgets);

}  // namespace talweg::paraview

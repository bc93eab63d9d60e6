// The module with all plugins of Talweg, which share one copy of the core.
#include "methods/plugins.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

TALWEG_PLUGIN_MODULE(bipartition_plugin, cut_plugin, distance_plugin, draw_plugin, envelope_plugin,
                     geodesic_plugin, labels_plugin, measure_plugin, midpoints_plugin,
                     offset_plugin, repair_plugin, smooth_plugin)

}  // namespace talweg::plugins

// The plugins of Talweg. Each is compiled in its own folder; module.cpp puts them into one module.
#pragma once

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::plugins {

const talweg_plugin* bipartition_plugin();
const talweg_plugin* cut_plugin();
const talweg_plugin* distance_plugin();
const talweg_plugin* draw_plugin();
const talweg_plugin* envelope_plugin();
const talweg_plugin* geodesic_plugin();
const talweg_plugin* labels_plugin();
const talweg_plugin* measure_plugin();
const talweg_plugin* midpoints_plugin();
const talweg_plugin* offset_plugin();
const talweg_plugin* repair_plugin();
const talweg_plugin* smooth_plugin();

}  // namespace talweg::plugins

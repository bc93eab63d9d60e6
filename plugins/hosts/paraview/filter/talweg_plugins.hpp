// Finds Talweg's plugins for the filters.
#pragma once

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// The plugin with this id. It is valid until the program ends. The search covers the folders of
/// TALWEG_PLUGIN_PATH; without this variable first talweg/plugins in the lib folder of this
/// library, then the loader's folders. Throws std::runtime_error with the folders, and the reasons
/// for refused files.
const talweg_plugin& plugin_named(const char* id);

}  // namespace talweg::paraview

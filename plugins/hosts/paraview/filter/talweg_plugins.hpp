// The filter finds Talweg's plugins here.
#pragma once

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {

/// The plugin with this id. It stays until the program ends. Looked for in the folders of
/// TALWEG_PLUGIN_PATH; without that variable first in talweg/plugins of the lib folder that this
/// library lies in, then where the loader looks.
/// Throws std::runtime_error with the folders, and why files in them were refused.
const talweg_plugin& plugin_named(const char* id);

}  // namespace talweg::paraview

// What plugins are on this system, and where they may lie.
#pragma once

#include <filesystem>
#include <string>

namespace talweg::loader {

extern const char* const kPluginEnding;  // ".so"
extern const char kBetweenFolders;       // ':'

/// The value of TALWEG_PLUGIN_PATH, which does not count in programs that run with another user's
/// rights.
std::string plugin_path();

/// Where this program lies; empty where the system does not tell.
std::filesystem::path program_file();

}  // namespace talweg::loader

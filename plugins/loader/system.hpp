// Properties of the operating system that the loader needs: the ending of plugins, folders, the
// program.
#pragma once

#include <filesystem>
#include <string>

namespace talweg::loader {

extern const char* const kPluginEnding;  // ".so"
extern const char kBetweenFolders;       // ':'

/// The value of TALWEG_PLUGIN_PATH, which does not count in programs that run with another user's
/// rights.
std::string plugin_path();

/// The path of the running program; empty if the system does not tell the path.
std::filesystem::path program_file();

}  // namespace talweg::loader

#include "system.hpp"

#include <cstdlib>
#include <system_error>

namespace talweg::loader {

const char* const kPluginEnding = ".so";
const char kBetweenFolders = ':';

std::string plugin_path() {
  const char* path = secure_getenv("TALWEG_PLUGIN_PATH");
  return path == nullptr ? "" : path;
}

std::filesystem::path program_file() {
  std::error_code failed;
  auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::path() : program;
}

}  // namespace talweg::loader

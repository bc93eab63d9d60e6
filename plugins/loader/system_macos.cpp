#include <cstdint>
#include <cstdlib>
#include <system_error>

#include <mach-o/dyld.h>
#include <unistd.h>

#include "system.hpp"

namespace talweg::loader {

const char* const kPluginEnding = ".so";
const char kBetweenFolders = ':';

std::string plugin_path() {
  const char* path = issetugid() != 0 ? nullptr : std::getenv("TALWEG_PLUGIN_PATH");
  return path == nullptr ? "" : path;
}

std::filesystem::path program_file() {
  std::uint32_t length = 0;
  _NSGetExecutablePath(nullptr, &length);  // gives the length
  std::string path(length, '\0');
  if (_NSGetExecutablePath(path.data(), &length) != 0) return {};
  std::error_code failed;
  auto program = std::filesystem::canonical(path.c_str(), failed);
  return failed ? std::filesystem::path() : program;
}

}  // namespace talweg::loader

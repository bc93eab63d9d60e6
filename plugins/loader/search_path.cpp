#include "search_path.hpp"

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>

namespace talweg::loader {

std::vector<std::string> split(const std::string& folders) {
  std::vector<std::string> result;
  std::istringstream stream(folders);
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) result.push_back(folder);
  }
  return result;
}

std::vector<std::string> standard_folders() {
  std::vector<std::string> all;
  if (const char* path = secure_getenv("TALWEG_PLUGIN_PATH")) all = split(path);
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto folder = program.parent_path();
    all.push_back((folder / TALWEG_PLUGINS_FROM_PROGRAM).lexically_normal().string());
    all.push_back((folder / "plugins").string());
  }
  all.emplace_back(TALWEG_INSTALLED_PLUGINS);

  std::vector<std::string> result;
  std::set<std::filesystem::path> seen;
  for (const std::string& folder : all) {
    const auto real = std::filesystem::weakly_canonical(folder, error);
    if (seen.insert(error ? std::filesystem::path(folder) : real).second) result.push_back(folder);
  }
  return result;
}

}  // namespace talweg::loader

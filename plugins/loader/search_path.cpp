#include "search_path.hpp"

#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

#include "system.hpp"

namespace talweg::loader {

std::vector<std::string> split(const std::string& folders) {
  std::vector<std::string> result;
  std::istringstream stream(folders);
  for (std::string folder; std::getline(stream, folder, kBetweenFolders);) {
    if (!folder.empty()) result.push_back(folder);
  }
  return result;
}

std::vector<std::string> standard_folders() {
  std::vector<std::string> all = split(plugin_path());
  const std::filesystem::path program = program_file();
  if (!program.empty()) {
    const auto folder = program.parent_path();
    all.push_back((folder / TALWEG_PLUGINS_FROM_PROGRAM).lexically_normal().string());
    all.push_back((folder / "plugins").string());
  }
  constexpr std::string_view kInstalled = TALWEG_INSTALLED_PLUGINS;
  if (!kInstalled.empty()) all.emplace_back(kInstalled);

  std::error_code error;
  std::vector<std::string> result;
  std::set<std::filesystem::path> seen;
  for (const std::string& folder : all) {
    const auto real = std::filesystem::weakly_canonical(folder, error);
    if (seen.insert(error ? std::filesystem::path(folder) : real).second) result.push_back(folder);
  }
  return result;
}

}  // namespace talweg::loader

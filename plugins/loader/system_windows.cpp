#include <cstdlib>

#include <windows.h>

#include "system.hpp"

namespace talweg::loader {

const char* const kPluginEnding = ".dll";
const char kBetweenFolders = ';';  // ':' follows the letter of a drive

std::string plugin_path() {
  const wchar_t* path = _wgetenv(L"TALWEG_PLUGIN_PATH");
  return path == nullptr ? "" : std::filesystem::path(path).string();
}

std::filesystem::path program_file() {
  constexpr std::size_t kLongest = 1 << 15;
  std::wstring file(kLongest, L'\0');
  file.resize(GetModuleFileNameW(nullptr, file.data(), static_cast<DWORD>(file.size())));
  return file;
}

}  // namespace talweg::loader

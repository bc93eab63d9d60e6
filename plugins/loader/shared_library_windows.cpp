#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <windows.h>

#include "shared_library.hpp"

namespace talweg::loader {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

std::string reason_of(DWORD error) {
  switch (error) {
    case ERROR_BAD_EXE_FORMAT:
      return "It is not a shared library for this kind of machine.";
    case ERROR_MOD_NOT_FOUND:
      return "It cannot be loaded: a library that it needs is missing.";
    case ERROR_PROC_NOT_FOUND:
      return "It cannot be loaded: a library that it needs is of another version.";
    default:
      break;
  }
  return "It cannot be loaded: " + std::system_category().message(static_cast<int>(error)) + ".";
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failed;
  fs::path full = fs::absolute(path, failed);
  if (failed || !fs::exists(full, failed)) refuse("It cannot be opened.");
  if (!fs::is_regular_file(full, failed)) refuse("It is not a file.");
  full.make_preferred();
  // A plugin's own libraries lie beside it. No window asks the user about a missing library.
  constexpr DWORD kSearch = LOAD_LIBRARY_SEARCH_DLL_LOAD_DIR | LOAD_LIBRARY_SEARCH_DEFAULT_DIRS;
  DWORD before = 0;
  SetThreadErrorMode(SEM_FAILCRITICALERRORS, &before);
  handle_ = LoadLibraryExW(full.c_str(), nullptr, kSearch);
  const DWORD error = GetLastError();
  SetThreadErrorMode(before, nullptr);
  if (handle_ == nullptr) refuse(reason_of(error));
}

SharedLibrary::~SharedLibrary() {
  if (handle_ != nullptr) FreeLibrary(static_cast<HMODULE>(handle_));
}

void* SharedLibrary::symbol(const char* name) const {
  const FARPROC found = GetProcAddress(static_cast<HMODULE>(handle_), name);
  void* symbol = nullptr;
  std::memcpy(&symbol, &found, sizeof symbol);
  return symbol;
}

}  // namespace talweg::loader

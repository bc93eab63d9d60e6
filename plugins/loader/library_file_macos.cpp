#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <mach-o/fat.h>
#include <mach-o/loader.h>
#include <sys/stat.h>

#include "library_file.hpp"

namespace talweg::loader {

// dlopen() itself refuses files that end too early.
void check_library_file(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) throw std::runtime_error("It cannot be opened.");
  if (!S_ISREG(status.st_mode)) throw std::runtime_error("It is not a file.");
  std::ifstream file(path, std::ios::binary);
  std::array<char, sizeof(std::uint32_t)> first = {};
  if (!file) throw std::runtime_error("It cannot be opened.");
  std::uint32_t magic = 0;
  if (file.read(first.data(), first.size())) std::memcpy(&magic, first.data(), sizeof magic);
  if (magic != MH_MAGIC_64 && magic != FAT_MAGIC && magic != FAT_CIGAM) {
    throw std::runtime_error("It is not a shared library.");
  }
}

}  // namespace talweg::loader

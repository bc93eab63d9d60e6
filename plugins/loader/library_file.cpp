#include "library_file.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <elf.h>
#include <sys/stat.h>

namespace talweg::loader {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

}  // namespace

// dlopen() maps a file as its headers say, and crashes the program if the file is shorter. So the
// file's length is checked first.
void check_library_file(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) refuse("It cannot be opened.");
  if (!S_ISREG(status.st_mode)) refuse("It is not a file.");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  std::ifstream file(path, std::ios::binary);
  Elf64_Ehdr header = {};
  if (!file) refuse("It cannot be opened.");
  if (!file.read(reinterpret_cast<char*>(&header), sizeof header) ||
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    refuse("It is not a shared library.");
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return;  // dlopen() reports the mismatch
  const std::uint64_t table = std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr);
  bool complete = header.e_phentsize == sizeof(Elf64_Phdr) && header.e_phoff <= size &&
                  table <= size - header.e_phoff;
  std::vector<Elf64_Phdr> segments(complete ? header.e_phnum : 0);
  file.seekg(static_cast<std::streamoff>(complete ? header.e_phoff : 0));
  complete = complete && file.read(reinterpret_cast<char*>(segments.data()),
                                   static_cast<std::streamsize>(table));
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type != PT_LOAD && segment.p_type != PT_DYNAMIC) continue;
    complete = complete && segment.p_offset <= size && segment.p_filesz <= size - segment.p_offset;
  }
  if (!complete) refuse("The library is not complete: the file ends too early.");
}

}  // namespace talweg::loader

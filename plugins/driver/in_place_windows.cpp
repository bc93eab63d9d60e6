#include <cerrno>
#include <cstdio>

#include "in_place.hpp"
#include "talweg/core/io/file_bytes.hpp"

namespace talweg::driver {
namespace {

void put(std::FILE& file, std::string_view bytes, const std::string& path) {
  errno = 0;
  const bool done = std::fwrite(bytes.data(), 1, bytes.size(), &file) == bytes.size();
  if (!done || std::fflush(&file) != 0) cannot_write(path, reason_of(errno));
}

}  // namespace

void write_in_place(const std::string& path, FileKind /*kind*/, std::string_view bytes) {
  const File file = open_file(path, FileUse::kAppend);
  if (!file) cannot_write(path, reason_of(errno));
  put(*file, bytes, path);
}

void write_standard_output(std::string_view bytes) { put(*stdout, bytes, "the standard output"); }

}  // namespace talweg::driver

#include "output_file.hpp"

#include <optional>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/system/files.hpp"

namespace talweg::driver {
namespace {

bool g_text_to_error = false;

}  // namespace

bool is_standard_output(std::string_view path) {
  return path == "-" ||
         (path.starts_with("-.") && path.find_first_of("/\\") == std::string_view::npos);
}

void write_output(const std::string& path, std::string_view bytes) {
  if (is_standard_output(path)) {
    std::fflush(stdout);
    return write_standard_output(bytes);
  }
  const std::optional<FileStatus> found = file_status(path);
  if (!found || found->kind == FileKind::kRegular || found->kind == FileKind::kFolder) {
    return write_file(path, bytes);
  }
  write_in_place(path, found->kind, bytes);
}

std::FILE* text_stream() { return g_text_to_error ? stderr : stdout; }

void keep_text_from_standard_output() { g_text_to_error = true; }

}  // namespace talweg::driver

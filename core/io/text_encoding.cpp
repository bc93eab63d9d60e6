#include "talweg/core/io/text_encoding.hpp"

#include <string>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

void check_encoding(const std::filesystem::path& path, std::string_view bytes) {
  using namespace std::string_view_literals;
  const bool wide = bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) ||
                    bytes.starts_with("\0\0\xFE\xFF"sv);
  if (wide) cannot_read(path, "it is text in UTF-16 or UTF-32; save it as UTF-8 or ASCII");
}

void check_no_nul(const std::filesystem::path& path, std::string_view bytes) {
  const std::size_t at = bytes.find('\0');
  if (at == std::string_view::npos) return;
  cannot_read(path, "line " + std::to_string(line_of(bytes, at)) + ": byte " + std::to_string(at) +
                        " is a NUL byte, so this is not a text file");
}

void check_line_ends(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.find('\n') != std::string_view::npos) return;
  if (bytes.find('\r') == std::string_view::npos) return;
  cannot_read(path, "its lines end in carriage returns alone; save it with line feeds");
}

}  // namespace talweg::formats

#include "talweg/core/io/xml_text.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

void load_xml(pugi::xml_document& document, const std::filesystem::path& path,
              std::string_view text) {
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (result) return;
  cannot_read(path, fmt::format("line {}: it is not well-formed XML ({})",
                                line_of(text, static_cast<std::size_t>(result.offset)),
                                result.description()));
}

}  // namespace talweg::formats

// XML text is parsed; an error names its line.
#pragma once

#include <filesystem>
#include <string_view>

#include <pugixml.hpp>

namespace talweg::formats {

/// Throws Error(kBadFile) that names the file and the line where the text is not well-formed.
void load_xml(pugi::xml_document& document, const std::filesystem::path& path,
              std::string_view text);

}  // namespace talweg::formats

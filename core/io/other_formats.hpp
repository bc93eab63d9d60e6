// Formats that are not read are near ones that are: what to do with their files.
#pragma once

#include <filesystem>
#include <string>

namespace talweg {

/// What to do with a file of a format that is known but not read, by its extension, as a part of a
/// sentence: ": it is a volume: ..."; empty for other extensions.
std::string instead_of(const std::filesystem::path& path);

}  // namespace talweg

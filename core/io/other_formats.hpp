// Other formats are known formats that are not read, with advice on converting their files.
#pragma once

#include <filesystem>
#include <string>

namespace talweg {

/// Advice on a file of a format that is known but not read, by its extension, as a part of a
/// sentence: ": it is a volume: ..."; empty for other extensions.
std::string instead_of(const std::filesystem::path& path);

}  // namespace talweg

// A text's encoding is checked, since the readers of text take it for UTF-8.
#pragma once

#include <filesystem>
#include <string_view>

namespace talweg::formats {

/// Throws Error(kBadFile) for text in UTF-16 or UTF-32 (it begins with their byte order mark).
void check_encoding(const std::filesystem::path& path, std::string_view bytes);

/// For line-based formats without a binary part: throws Error(kBadFile) naming the line of a NUL
/// byte. Readers skip lines that they do not know, so a NUL byte could hide a vertex.
void check_no_nul(const std::filesystem::path& path, std::string_view bytes);

/// For line-based formats: throws Error(kBadFile) for a file whose lines end in carriage returns
/// alone, because it would be read as one line.
void check_line_ends(const std::filesystem::path& path, std::string_view bytes);

}  // namespace talweg::formats

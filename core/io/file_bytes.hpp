// A file's bytes are read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace talweg {

/// The file's bytes. Pipes work too. Throws Error(kBadFile) naming path and reason when it cannot
/// be opened or read, is a directory, is empty, is larger than 2 GiB, or changes meanwhile.
std::string read_file(const std::filesystem::path& path);

/// Writes beside the target and renames, so that the target is either as it was or complete.
/// Keeps the permissions of an existing file and follows symbolic links; what is no regular file
/// (/dev/stdout) is written in place. Throws Error(kBadFile) naming path and reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws what write_file() would, as far as that can be known before: the folder is missing or
/// cannot be written in, the path is a directory, its name is too long. Makes the file that
/// write_file() would begin with, and removes it; the target is not touched.
void check_writable(const std::filesystem::path& path);

/// Throws Error(kBadFile): "Cannot read PATH: WHAT."
[[noreturn]] void cannot_read(const std::filesystem::path& path, const std::string& what);
/// Throws Error(kBadFile): "Cannot write PATH: WHAT."
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& what);

}  // namespace talweg

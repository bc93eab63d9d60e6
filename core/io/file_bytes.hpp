// Files are read and written as a whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace talweg {

/// The file's bytes. Pipes work too. Throws Error(kBadFile) naming path and reason when it cannot
/// be opened or read, is a directory, is empty, is larger than 2 GiB, or changes while it is read.
std::string read_file(const std::filesystem::path& path);

/// Writes a new file beside the target and renames it, so that the target is either unchanged or
/// complete. Keeps the permissions of an existing file and follows symbolic links; a target that is
/// not a regular file (/dev/stdout) is written in place. Throws Error(kBadFile) naming path and
/// reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws as write_file() would if the folder is missing or not writable, the path is a directory,
/// or its name is too long. Creates the temporary file of write_file() and removes it; the target
/// is not touched.
void check_writable(const std::filesystem::path& path);

/// Throws Error(kBadFile): "Cannot read PATH: WHAT."
[[noreturn]] void cannot_read(const std::filesystem::path& path, const std::string& what);
/// Throws Error(kBadFile): "Cannot write PATH: WHAT."
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& what);

}  // namespace talweg

// Functions of the operating system for files: their status, opening them, and replacing a file by
// another.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace talweg {

enum class FileKind { kRegular, kFolder, kPipe, kDevice, kOther };

struct FileStatus {
  FileKind kind = FileKind::kRegular;
  std::uint64_t device = 0, number = 0;  ///< together the same for all names of one file
  std::uint64_t size = 0;                ///< in bytes; 0 for devices and pipes
  std::int64_t written = 0;  ///< time of the last write, in the smallest unit of the system
};

/// The status of the file or folder at a path; links are followed. None if nothing is there.
std::optional<FileStatus> file_status(const std::filesystem::path& path);
FileStatus file_status(std::FILE& file);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// kWrite empties an existing file; kNew fails with EEXIST if the file exists.
enum class FileUse { kRead, kWrite, kAppend, kNew };

/// Opens a file in binary mode. Other programs may read, write, rename and remove the file
/// meanwhile. Null on failure; errno has the reason.
File open_file(const std::filesystem::path& path, FileUse use);

/// Whether the user may write the file, or make files in the folder; if not, errno has the reason.
/// On Windows only the read-only attribute of files counts.
bool may_write(const std::filesystem::path& path);

/// Renames `fresh` to `target`. On POSIX the renamed file has the permissions of an existing
/// `target`; on Windows the call waits up to two seconds while another program has `target` open.
/// Returns the reason of a failure; empty on success.
std::string take_place(const std::filesystem::path& fresh, const std::filesystem::path& target);

/// Removes a file. Does nothing if the file does not exist.
void remove_file(const std::filesystem::path& path);

/// The spelling in which file names are compared if the files do not exist yet: lower case on
/// Windows, otherwise the name itself.
std::filesystem::path common_spelling(const std::filesystem::path& name);

/// The device that discards all bytes: "/dev/null", on Windows "NUL".
const char* null_device();

/// A value of errno in words: "No such file or directory".
std::string reason_of(int error);

}  // namespace talweg

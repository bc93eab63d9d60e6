// Files as the system has them: what a path names, how a file is opened, how one takes another's
// place.
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
  std::uint64_t device = 0, number = 0;  ///< the same for all names of a file
  std::uint64_t size = 0;                ///< in bytes; 0 for devices and pipes
  std::int64_t written = 0;  ///< time of the last write, in the smallest unit of the system
};

/// The status of the file or folder at a path, behind links. None if nothing is there.
std::optional<FileStatus> file_status(const std::filesystem::path& path);
FileStatus file_status(std::FILE& file);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// kWrite empties an existing file, kNew fails with EEXIST where there is one.
enum class FileUse { kRead, kWrite, kAppend, kNew };

/// Opens a file in binary mode. Other programs may read, write, rename and remove the file
/// meanwhile. Null on failure; errno has the reason.
File open_file(const std::filesystem::path& path, FileUse use);

/// Whether the user may write the file, or make files in the folder; else errno says why.
bool may_write(const std::filesystem::path& path);

/// `fresh` gets the name of `target`, and the permissions of the file that had it. Returns the
/// reason of a failure; empty on success.
std::string take_place(const std::filesystem::path& fresh, const std::filesystem::path& target);

/// Removes a file. Does nothing if the file does not exist.
void remove_file(const std::filesystem::path& path);

/// The name in the spelling by which names of a file that does not exist yet are compared: in small
/// letters on Windows.
std::filesystem::path common_spelling(const std::filesystem::path& name);

/// The device that discards all bytes: "/dev/null", on Windows "NUL".
const char* null_device();

/// A value of errno in words: "No such file or directory".
std::string reason_of(int error);

}  // namespace talweg

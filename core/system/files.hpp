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
  std::uint64_t size = 0;                ///< in bytes; 0 for what has no size
  std::int64_t written = 0;              ///< when, in the smallest unit that the system counts
};

/// Of what a path leads to, behind links; nothing where nothing is.
std::optional<FileStatus> file_status(const std::filesystem::path& path);
FileStatus file_status(std::FILE& file);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// kWrite empties an existing file, kNew fails with EEXIST where there is one.
enum class FileUse { kRead, kWrite, kAppend, kNew };

/// Bytes as they are. Other programs may read, write, rename and remove the file meanwhile. Null on
/// failure; errno says why.
File open_file(const std::filesystem::path& path, FileUse use);

/// Whether the user may write the file, or make files in the folder; else errno says why.
bool may_write(const std::filesystem::path& path);

/// `fresh` gets the name of `target`, and the permissions of the file that had it. Returns the
/// reason of a failure; empty on success.
std::string take_place(const std::filesystem::path& fresh, const std::filesystem::path& target);

/// Where there is none, nothing happens.
void remove_file(const std::filesystem::path& path);

/// The spelling that all names of a file have in common, where it does not exist yet: in small
/// letters on Windows.
std::filesystem::path common_spelling(const std::filesystem::path& name);

/// What is written there is gone: "/dev/null".
const char* null_device();

/// A value of errno in words: "No such file or directory".
std::string reason_of(int error);

}  // namespace talweg

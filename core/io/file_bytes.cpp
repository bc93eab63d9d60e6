#include "talweg/core/io/file_bytes.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <system_error>

#include "talweg/core/system/files.hpp"
#include "talweg/core/system/process.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{1} << 31;
constexpr const char* kTooLarge = "it is larger than 2 GiB";
constexpr int kTemporaryNames = 1000;

/// Detects that a file was written during reading. A mixture of the old and the new file could pass
/// as a mesh.
bool changed(const FileStatus& before, const FileStatus& now) {
  return before.size != now.size || before.written != now.written;
}

/// Writes the bytes. Returns the reason of a failure; empty on success.
std::string put(File file, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const int write_errno = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed) return {};
  return reason_of(written ? errno : write_errno);
}

/// The file to replace: the target of a symbolic link, otherwise the path itself.
fs::path target_of(const fs::path& path) {
  std::error_code failed;
  fs::path target = fs::canonical(path, failed);
  return failed ? path : target;
}

/// Creates a new file beside the target. The name contains the process id, so that files left
/// behind by killed processes do not block names.
File open_beside(const fs::path& target, fs::path& temporary) {
  for (int k = 0; k < kTemporaryNames; ++k) {
    temporary = target;
    temporary += ".tmp" + std::to_string(process_number()) + "-" + std::to_string(k);
    File file = open_file(temporary, FileUse::kNew);
    if (file || errno != EEXIST) return file;
  }
  return nullptr;
}

}  // namespace

void cannot_read(const fs::path& path, const std::string& what) {
  throw Error(ErrorCode::kBadFile, "Cannot read " + path.string() + ": " + what + ".");
}

void cannot_write(const fs::path& path, const std::string& what) {
  throw Error(ErrorCode::kBadFile, "Cannot write " + path.string() + ": " + what + ".");
}

std::string read_file(const fs::path& path) {
  const std::optional<FileStatus> found = file_status(path);
  if (found && found->kind == FileKind::kFolder) cannot_read(path, "it is a directory");
  const File file = open_file(path, FileUse::kRead);
  if (!file) cannot_read(path, reason_of(errno));
  std::string bytes;
  // Reserves memory if the size is known, to avoid copies; a pipe has no size.
  const FileStatus before = file_status(*file);
  if (before.size > kLargestFile) cannot_read(path, kTooLarge);
  bytes.reserve(static_cast<std::size_t>(before.size));
  char block[1 << 16];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, file.get())) > 0;) {
    bytes.append(block, got);
    if (bytes.size() > kLargestFile) cannot_read(path, kTooLarge);
  }
  if (std::ferror(file.get())) cannot_read(path, reason_of(errno));
  if (before.kind == FileKind::kRegular && changed(before, file_status(*file))) {
    cannot_read(path, "it changed while it was being read");
  }
  if (bytes.empty()) cannot_read(path, "the file is empty");
  return bytes;
}

void check_writable(const fs::path& path) {
  const std::optional<FileStatus> found = file_status(path);
  if (found && found->kind == FileKind::kFolder) cannot_write(path, "it is a directory");
  if (found && found->kind != FileKind::kRegular) {
    if (!may_write(path)) cannot_write(path, reason_of(errno));
    return;
  }
  if (!path.has_filename()) cannot_write(path, "it is the name of a directory");
  fs::path temporary;
  const bool opened = open_beside(target_of(path), temporary) != nullptr;
  if (!opened) cannot_write(path, reason_of(errno));
  remove_file(temporary);
}

void write_file(const fs::path& path, std::string_view bytes) {
  const std::optional<FileStatus> found = file_status(path);
  if (found && found->kind == FileKind::kFolder) cannot_write(path, "it is a directory");
  if (found && found->kind != FileKind::kRegular) {
    File file = open_file(path, FileUse::kWrite);
    const std::string reason = file ? put(std::move(file), bytes) : reason_of(errno);
    if (!reason.empty()) cannot_write(path, reason);
    return;
  }
  const fs::path target = target_of(path);
  fs::path temporary;
  File file = open_beside(target, temporary);
  if (!file) cannot_write(path, reason_of(errno));
  std::string reason = put(std::move(file), bytes);
  if (reason.empty()) reason = take_place(temporary, target);
  if (reason.empty()) return;
  remove_file(temporary);
  cannot_write(path, reason);
}

}  // namespace talweg

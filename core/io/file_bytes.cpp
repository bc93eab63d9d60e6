#include "talweg/core/io/file_bytes.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

constexpr std::size_t kLargestFile = std::size_t{1} << 31;
constexpr const char* kTooLarge = "it is larger than 2 GiB";
constexpr int kTemporaryNames = 1000;

struct stat status_of(std::FILE& file) {
  struct stat status {};
  static_cast<void>(fstat(fileno(&file), &status));
  return status;
}

/// Detects that a file was written during reading. A mixture of the old and the new file could pass
/// as a mesh.
bool changed(const struct stat& before, const struct stat& now) {
  return before.st_size != now.st_size || before.st_mtim.tv_sec != now.st_mtim.tv_sec ||
         before.st_mtim.tv_nsec != now.st_mtim.tv_nsec;
}

/// Writes the bytes. Returns the reason of a failure; empty on success.
std::string put(File file, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const int write_errno = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed) return {};
  return std::strerror(written ? errno : write_errno);
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
    temporary += ".tmp" + std::to_string(getpid()) + "-" + std::to_string(k);
    File file(std::fopen(temporary.c_str(), "wbx"));
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
  std::error_code status;
  if (fs::is_directory(path, status)) cannot_read(path, "it is a directory");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) cannot_read(path, std::strerror(errno));
  std::string bytes;
  // Reserves memory if the size is known, to avoid copies; a pipe has no size.
  const struct stat before = status_of(*file);
  const auto size = static_cast<std::size_t>(before.st_size);
  if (size > kLargestFile) cannot_read(path, kTooLarge);
  bytes.reserve(size);
  char block[1 << 16];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, file.get())) > 0;) {
    bytes.append(block, got);
    if (bytes.size() > kLargestFile) cannot_read(path, kTooLarge);
  }
  if (std::ferror(file.get())) cannot_read(path, std::strerror(errno));
  if (S_ISREG(before.st_mode) && changed(before, status_of(*file))) {
    cannot_read(path, "it changed while it was being read");
  }
  if (bytes.empty()) cannot_read(path, "the file is empty");
  return bytes;
}

void check_writable(const fs::path& path) {
  std::error_code status;
  const bool exists = fs::exists(path, status);
  if (exists && fs::is_directory(path, status)) cannot_write(path, "it is a directory");
  if (exists && !fs::is_regular_file(path, status)) {
    if (access(path.c_str(), W_OK) != 0) cannot_write(path, std::strerror(errno));
    return;
  }
  if (!path.has_filename()) cannot_write(path, "it is the name of a directory");
  fs::path temporary;
  const File file = open_beside(target_of(path), temporary);
  if (!file) cannot_write(path, std::strerror(errno));
  fs::remove(temporary, status);
}

void write_file(const fs::path& path, std::string_view bytes) {
  std::error_code status;
  const bool exists = fs::exists(path, status);
  if (exists && fs::is_directory(path, status)) cannot_write(path, "it is a directory");
  if (exists && !fs::is_regular_file(path, status)) {
    File file(std::fopen(path.c_str(), "wb"));
    const std::string reason = file ? put(std::move(file), bytes) : std::strerror(errno);
    if (!reason.empty()) cannot_write(path, reason);
    return;
  }
  const fs::path target = target_of(path);
  fs::path temporary;
  File file = open_beside(target, temporary);
  if (!file) cannot_write(path, std::strerror(errno));
  std::string reason = put(std::move(file), bytes);
  if (reason.empty()) {
    std::error_code failed;
    if (exists) fs::permissions(temporary, fs::status(target).permissions(), failed);
    fs::rename(temporary, target, failed);
    if (failed) reason = failed.message();
  }
  if (reason.empty()) return;
  fs::remove(temporary, status);
  cannot_write(path, reason);
}

}  // namespace talweg

#include "talweg/core/system/files.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace talweg {
namespace {

namespace fs = std::filesystem;

FileKind kind_of(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return FileKind::kRegular;
  if (S_ISDIR(status.st_mode)) return FileKind::kFolder;
  if (S_ISFIFO(status.st_mode)) return FileKind::kPipe;
  return S_ISCHR(status.st_mode) ? FileKind::kDevice : FileKind::kOther;
}

FileStatus status_of(const struct stat& status) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
#if defined(__APPLE__)
  const timespec& written = status.st_mtimespec;
#else
  const timespec& written = status.st_mtim;
#endif
  return {kind_of(status), static_cast<std::uint64_t>(status.st_dev),
          static_cast<std::uint64_t>(status.st_ino), static_cast<std::uint64_t>(status.st_size),
          written.tv_sec * kNanoseconds + written.tv_nsec};
}

const char* mode_of(FileUse use) {
  switch (use) {
    case FileUse::kRead:
      return "rb";
    case FileUse::kWrite:
      return "wb";
    case FileUse::kAppend:
      return "ab";
    case FileUse::kNew:
      break;
  }
  return "wbx";
}

}  // namespace

std::optional<FileStatus> file_status(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status_of(status);
}

FileStatus file_status(std::FILE& file) {
  struct stat status {};
  static_cast<void>(fstat(fileno(&file), &status));
  return status_of(status);
}

File open_file(const fs::path& path, FileUse use) {
  return File(std::fopen(path.c_str(), mode_of(use)));
}

bool may_write(const fs::path& path) {
  std::error_code failed;
  return access(path.c_str(), fs::is_directory(path, failed) ? W_OK | X_OK : W_OK) == 0;
}

std::string take_place(const fs::path& fresh, const fs::path& target) {
  std::error_code failed;
  const fs::file_status old = fs::status(target, failed);
  if (fs::exists(old)) fs::permissions(fresh, old.permissions(), failed);
  fs::rename(fresh, target, failed);
  return failed ? failed.message() : std::string();
}

void remove_file(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

fs::path common_spelling(const fs::path& name) { return name; }

const char* null_device() { return "/dev/null"; }

std::string reason_of(int error) { return std::strerror(error); }

}  // namespace talweg

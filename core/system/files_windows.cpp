#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "talweg/core/system/files.hpp"

namespace talweg {
namespace {

namespace fs = std::filesystem;

/// The path in a form that Windows accepts at any length. Absolute paths of 260 characters or more
/// need the prefix \\?\.
std::wstring long_name(const fs::path& path) {
  constexpr DWORD kShort = 240;  // leaves room for a short file name in a folder
  const DWORD length = GetFullPathNameW(path.c_str(), 0, nullptr, nullptr);
  if (length < kShort) return path.native();
  std::wstring full(length, L'\0');
  full.resize(GetFullPathNameW(path.c_str(), length, full.data(), nullptr));
  if (full.starts_with(LR"(\\?\)") || full.starts_with(LR"(\\.\)")) return full;
  if (full.starts_with(LR"(\\)")) return LR"(\\?\UNC\)" + full.substr(2);
  return LR"(\\?\)" + full;
}

class Handle {
 public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  ~Handle() {
    if (found()) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  [[nodiscard]] bool found() const { return handle_ != INVALID_HANDLE_VALUE; }
  [[nodiscard]] HANDLE get() const { return handle_; }
  HANDLE release() { return std::exchange(handle_, INVALID_HANDLE_VALUE); }

 private:
  HANDLE handle_;
};

constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

std::uint64_t wide(DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; }

FileStatus status_of(HANDLE handle) {
  FileStatus status;
  const DWORD type = GetFileType(handle);
  if (type == FILE_TYPE_CHAR) status.kind = FileKind::kDevice;
  if (type == FILE_TYPE_PIPE) status.kind = FileKind::kPipe;
  if (type == FILE_TYPE_UNKNOWN) status.kind = FileKind::kOther;
  // Only files on disks have a volume and a number. For others, these small numbers equal those of
  // no file on a disk.
  status.device = type;
  DWORD mode = 0;
  status.number = GetConsoleMode(handle, &mode) != 0 ? 1 : 0;
  BY_HANDLE_FILE_INFORMATION about{};
  if (type != FILE_TYPE_DISK || GetFileInformationByHandle(handle, &about) == 0) return status;
  if ((about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) status.kind = FileKind::kFolder;
  status.device = about.dwVolumeSerialNumber;
  status.number = wide(about.nFileIndexHigh, about.nFileIndexLow);
  status.size = wide(about.nFileSizeHigh, about.nFileSizeLow);
  status.written = static_cast<std::int64_t>(
      wide(about.ftLastWriteTime.dwHighDateTime, about.ftLastWriteTime.dwLowDateTime));
  return status;
}

int errno_of(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_BAD_NETPATH:
    case ERROR_INVALID_DRIVE:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_WRITE_PROTECT:
      return EACCES;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      return EBUSY;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_FILENAME_EXCED_RANGE:
      return ENAMETOOLONG;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
      return EINVAL;
    case ERROR_TOO_MANY_OPEN_FILES:
      return EMFILE;
    case ERROR_NOT_ENOUGH_MEMORY:
      return ENOMEM;
    default:
      return EIO;
  }
}

struct Opening {
  DWORD access, disposition;
  int flags;
  const char* mode;
};

Opening opening_for(FileUse use) {
  switch (use) {
    case FileUse::kRead:
      return {GENERIC_READ, OPEN_EXISTING, _O_RDONLY, "rb"};
    case FileUse::kWrite:
      return {GENERIC_WRITE, CREATE_ALWAYS, _O_WRONLY, "wb"};
    case FileUse::kAppend:
      return {FILE_APPEND_DATA, OPEN_ALWAYS, _O_WRONLY | _O_APPEND, "ab"};
    case FileUse::kNew:
      break;
  }
  return {GENERIC_WRITE, CREATE_NEW, _O_WRONLY, "wb"};
}

}  // namespace

std::optional<FileStatus> file_status(const fs::path& path) {
  const Handle handle(CreateFileW(long_name(path).c_str(), FILE_READ_ATTRIBUTES, kShared, nullptr,
                                  OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr));
  if (!handle.found()) return std::nullopt;
  return status_of(handle.get());
}

FileStatus file_status(std::FILE& file) {
  return status_of(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(&file))));
}

File open_file(const fs::path& path, FileUse use) {
  const Opening how = opening_for(use);
  Handle handle(CreateFileW(long_name(path).c_str(), how.access, kShared, nullptr, how.disposition,
                            FILE_ATTRIBUTE_NORMAL, nullptr));
  if (!handle.found()) {
    errno = errno_of(GetLastError());
    return nullptr;
  }
  const int descriptor =
      _open_osfhandle(reinterpret_cast<intptr_t>(handle.get()), how.flags | _O_BINARY);
  if (descriptor < 0) return nullptr;
  handle.release();
  File file(_fdopen(descriptor, how.mode));
  if (!file) _close(descriptor);
  return file;
}

bool may_write(const fs::path& path) {
  constexpr int kWritable = 2;
  return _waccess(long_name(path).c_str(), kWritable) == 0;
}

/// Windows does not replace a file that another program reads, so readers get two seconds to
/// finish.
std::string take_place(const fs::path& fresh, const fs::path& target) {
  constexpr int kTries = 40;
  constexpr DWORD kPauseMs = 50;
  const std::wstring from = long_name(fresh), to = long_name(target);
  for (int k = 1;; ++k) {
    if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) != 0) return {};
    const DWORD error = GetLastError();
    const bool taken = error == ERROR_SHARING_VIOLATION || error == ERROR_LOCK_VIOLATION ||
                       error == ERROR_ACCESS_DENIED || error == ERROR_USER_MAPPED_FILE;
    if (!taken || k == kTries) return reason_of(taken ? EBUSY : errno_of(error));
    Sleep(kPauseMs);
  }
}

void remove_file(const fs::path& path) { DeleteFileW(long_name(path).c_str()); }

fs::path common_spelling(const fs::path& name) {
  std::wstring small = name.native();
  CharLowerBuffW(small.data(), static_cast<DWORD>(small.size()));
  return small;
}

const char* null_device() { return "NUL"; }

std::string reason_of(int error) {
  if (error == EBUSY) return "another program has it open, or it is write-protected";
  if (error == EINVAL) return "such a name is not allowed";
  return std::strerror(error);
}

}  // namespace talweg

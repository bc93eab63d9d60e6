#include "in_place.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "cancellation.hpp"
#include "talweg/core/io/file_bytes.hpp"

namespace talweg::driver {
namespace {

constexpr int kPatienceMs = 50;  // between two checks for a signal

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

[[noreturn]] void failed(const std::string& path) { cannot_write(path, reason_of(errno)); }

/// Opens an existing file that is not a regular file. To open a pipe would wait for a reader and
/// ignore signals, so opening is tried again and again without waiting.
int open_in_place(const std::string& path, bool pipe) {
  for (;;) {
    const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | (pipe ? O_NONBLOCK : 0));
    if (file >= 0) return file;
    if (!(pipe && errno == ENXIO) && errno != EINTR) failed(path);
    if (interrupted()) throw WaitCancelled{path};
    poll(nullptr, 0, kPatienceMs);
  }
}

/// Writes in pieces that a ready pipe takes without blocking.
void put(int file, FileKind kind, std::string_view bytes, const std::string& path) {
  const std::size_t most = kind == FileKind::kRegular ? std::size_t{1} << 20 : PIPE_BUF;
  while (!bytes.empty()) {
    pollfd ready{file, POLLOUT, 0};
    const int count = poll(&ready, 1, kPatienceMs);
    if (count <= 0) {
      if (interrupted()) throw WaitCancelled{path};
      continue;
    }
    const ssize_t done = ::write(file, bytes.data(), std::min(bytes.size(), most));
    if (done >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(done));
    } else if (errno != EINTR && errno != EAGAIN) {
      failed(path);
    }
  }
}

}  // namespace

void write_in_place(const std::string& path, FileKind kind, std::string_view bytes) {
  const Descriptor file{open_in_place(path, kind == FileKind::kPipe)};
  put(file.number, kind, bytes, path);
}

void write_standard_output(std::string_view bytes) {
  put(STDOUT_FILENO, file_status(*stdout).kind, bytes, "the standard output");
}

}  // namespace talweg::driver

#include "output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cancellation.hpp"
#include "talweg/core/io/file_bytes.hpp"

namespace talweg::driver {
namespace {

constexpr int kPatienceMs = 50;  // between two checks for a signal

bool g_text_to_error = false;

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

[[noreturn]] void failed(const std::string& path) {
  cannot_write(is_standard_output(path) ? "the standard output" : path, std::strerror(errno));
}

/// Opens an existing file that is not a regular one. Opening a pipe would wait for a reader and
/// ignore signals, so it is retried without waiting.
int open_in_place(const std::string& path, bool pipe) {
  for (;;) {
    const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | (pipe ? O_NONBLOCK : 0));
    if (file >= 0) return file;
    if (!(pipe && errno == ENXIO) && errno != EINTR) failed(path);
    if (interrupted()) throw WaitCancelled{path};
    poll(nullptr, 0, kPatienceMs);
  }
}

/// Writes at most as much at once as a ready pipe takes without blocking.
void put(int file, std::string_view bytes, const std::string& path) {
  struct stat status {};
  fstat(file, &status);
  const std::size_t most = S_ISREG(status.st_mode) ? std::size_t{1} << 20 : PIPE_BUF;
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

bool is_standard_output(std::string_view path) {
  return path == "-" || (path.starts_with("-.") && path.find('/') == std::string_view::npos);
}

void write_output(const std::string& path, std::string_view bytes) {
  if (is_standard_output(path)) {
    std::fflush(stdout);
    return put(STDOUT_FILENO, bytes, path);
  }
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (!exists || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) {
    return write_file(path, bytes);
  }
  const Descriptor file{open_in_place(path, S_ISFIFO(status.st_mode))};
  put(file.number, bytes, path);
}

std::FILE* text_stream() { return g_text_to_error ? stderr : stdout; }

void keep_text_from_standard_output() { g_text_to_error = true; }

}  // namespace talweg::driver

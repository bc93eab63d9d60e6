#include "talweg/heat/process_lock.hpp"

#if __has_include(<sys/file.h>) && !defined(_WIN32)  // whose rand() has a state for each thread
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace talweg {

ProcessLock::ProcessLock(Resource resource) {
  const char* own = resource == Resource::kOpenBlas ? "/proc/self/comm" : "/proc/self/stat";
  file_ = open(own, O_RDONLY | O_CLOEXEC);
  while (file_ >= 0 && flock(file_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

ProcessLock::~ProcessLock() {
  if (file_ < 0) return;
  flock(file_, LOCK_UN);  // closing alone keeps the lock if a forked child has the file, too
  close(file_);
}

}  // namespace talweg

#else

namespace talweg {

ProcessLock::ProcessLock(Resource) {}
ProcessLock::~ProcessLock() = default;

}  // namespace talweg

#endif

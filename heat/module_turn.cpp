#include "talweg/heat/module_turn.hpp"

#if __has_include(<sys/file.h>)
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace talweg {

ModuleTurn::ModuleTurn(Resource resource) {
  const char* own = resource == Resource::kOpenBlas ? "/proc/self/comm" : "/proc/self/stat";
  file_ = open(own, O_RDONLY | O_CLOEXEC);
  while (file_ >= 0 && flock(file_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

ModuleTurn::~ModuleTurn() {
  if (file_ < 0) return;
  flock(file_, LOCK_UN);  // closing alone keeps the lock if a forked child has the file, too
  close(file_);
}

}  // namespace talweg

#else

namespace talweg {

ModuleTurn::ModuleTurn(Resource) {}
ModuleTurn::~ModuleTurn() = default;

}  // namespace talweg

#endif

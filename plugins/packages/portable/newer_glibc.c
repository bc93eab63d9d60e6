// Symbols that libstdc++ 12, built on glibc 2.36, needs, and that glibc 2.31 does not have.
#include <sys/random.h>

// In glibc 2.32 and later this flag tells that a process has a single thread, to save atomic
// operations.
__attribute__((visibility("hidden"))) char __libc_single_threaded = 0;

// In glibc 2.36 and later; used by std::random_device.
__attribute__((visibility("hidden"))) unsigned arc4random(void) {
  unsigned number = 0;
  while (getrandom(&number, sizeof number, 0) != sizeof number) {
  }
  return number;
}

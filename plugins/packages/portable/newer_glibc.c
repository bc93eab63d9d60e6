// What libstdc++ 12, built on glibc 2.36, asks for and glibc 2.31 does not have.
#include <sys/random.h>

// glibc 2.32 says here that a process has one thread only, to save atomic operations.
__attribute__((visibility("hidden"))) char __libc_single_threaded = 0;

// glibc 2.36; behind std::random_device.
__attribute__((visibility("hidden"))) unsigned arc4random(void) {
  unsigned number = 0;
  while (getrandom(&number, sizeof number, 0) != sizeof number) {
  }
  return number;
}

// A process lock guards a resource that all modules of a process share, such as rand().
#pragma once

namespace talweg {

/// Each statically linked plugin of a process has its own copy of this library and of its mutexes,
/// but all copies share rand() and OpenBLAS. While a ProcessLock lives, the constructor of another
/// ProcessLock of the same resource waits, in whichever module of the process. The lock is a lock
/// on a file of /proc/self, which no other process has. Without /proc, a ProcessLock does nothing.
class ProcessLock {
 public:
  enum class Resource { kRandomNumbers, kOpenBlas };

  explicit ProcessLock(Resource resource);
  ~ProcessLock();
  ProcessLock(const ProcessLock&) = delete;
  ProcessLock& operator=(const ProcessLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace talweg

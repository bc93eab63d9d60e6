// A module's turn locks a resource that all modules of the process share, such as rand().
#pragma once

namespace talweg {

/// Each statically linked plugin of a process has its own copy of this library and of its mutexes,
/// but all copies share rand() and OpenBLAS. While a ModuleTurn lives, the constructor of another
/// ModuleTurn of the same resource waits, in whichever module of the process. The lock is a lock on
/// a file of /proc/self, which no other process has. Without /proc, a ModuleTurn does nothing.
class ModuleTurn {
 public:
  enum class Resource { kRandomNumbers, kOpenBlas };

  explicit ModuleTurn(Resource resource);
  ~ModuleTurn();
  ModuleTurn(const ModuleTurn&) = delete;
  ModuleTurn& operator=(const ModuleTurn&) = delete;

 private:
  int file_ = -1;
};

}  // namespace talweg

// A module's turn keeps the other modules of the process out of what they share without knowing.
#pragma once

namespace talweg {

/// Plugins that are linked statically have each its own copy of these libraries in one process, and
/// so of every mutex; but rand() and OpenBLAS are there once. While one of these lives, no other of
/// the same resource is made in this process: its maker waits. The lock is one on a file that no
/// other process has; where there is no /proc, it does nothing.
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

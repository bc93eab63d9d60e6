// Ending threads have been asked to stop, but a host has no time to wait for their end.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace talweg::editing {

/// Owns threads until they end. Any thread may call the methods.
class EndingThreads {
 public:
  EndingThreads() = default;
  ~EndingThreads() { end(); }
  EndingThreads(const EndingThreads&) = delete;
  EndingThreads& operator=(const EndingThreads&) = delete;

  /// Takes a thread over and returns at once. The thread must set `ended` at its very end, and must
  /// own the data that it uses.
  void take(std::thread thread, std::shared_ptr<const std::atomic<bool>> ended);
  /// Waits for the end of all threads, but no longer than 0.7 s. Threads that still run, for
  /// example in a plugin that never returns, are detached; then the result is false.
  bool end();

 private:
  struct Ending {
    std::thread thread;
    std::shared_ptr<const std::atomic<bool>> ended;
  };
  std::mutex mutex_;
  std::vector<Ending> threads_;
};

}  // namespace talweg::editing

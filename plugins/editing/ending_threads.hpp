// Ending threads have been told to stop, and nobody has the time to wait for them.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace talweg::editing {

/// May be used from any thread.
class EndingThreads {
 public:
  EndingThreads() = default;
  ~EndingThreads() { end(); }
  EndingThreads(const EndingThreads&) = delete;
  EndingThreads& operator=(const EndingThreads&) = delete;

  /// The thread sets `ended` as the last thing that it does. Does not wait for it. The thread must
  /// own what it uses.
  void take(std::thread thread, std::shared_ptr<const std::atomic<bool>> ended);
  /// Waits for all of them, but no longer than 0.7 s: a thread in a plugin that never returns is
  /// left to itself. False if there is one.
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

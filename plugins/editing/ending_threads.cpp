#include "ending_threads.hpp"

#include <chrono>
#include <utility>

namespace talweg::editing {
namespace {

constexpr std::chrono::milliseconds kPatience(700);  // a host is to close within two seconds

}  // namespace

bool EndingThreads::end() {
  const std::scoped_lock lock(mutex_);
  bool all = true;
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  for (Ending& ending : threads_) {
    while (!*ending.ended && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (*ending.ended) {
      ending.thread.join();
    } else {
      ending.thread.detach();
      all = false;
    }
  }
  threads_.clear();
  return all;
}

void EndingThreads::take(std::thread thread, std::shared_ptr<const std::atomic<bool>> ended) {
  const std::scoped_lock lock(mutex_);
  threads_.push_back({std::move(thread), std::move(ended)});
  std::erase_if(threads_, [](Ending& ending) {
    if (!*ending.ended) return false;
    ending.thread.join();
    return true;
  });
}

}  // namespace talweg::editing

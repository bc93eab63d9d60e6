#include "ending_threads.hpp"

#include <utility>

namespace talweg::editing {

EndingThreads::~EndingThreads() {
  for (Ending& ending : threads_) ending.thread.join();
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

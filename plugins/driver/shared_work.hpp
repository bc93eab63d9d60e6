// Shared work is a list of tasks that several threads take one after another.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace talweg::driver {

/// Calls work(worker, i) once for every i in [0, count), in this order as workers become free;
/// `worker` in [0, workers) is the calling worker's number. The first worker is the calling thread.
/// An exception from `work` stops all workers and is rethrown here.
template <class Work>
void share_work(std::size_t count, std::size_t workers, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto go = [&](std::size_t worker) {
    try {
      for (std::size_t i; (i = next.fetch_add(1)) < count;) work(worker, i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t worker = 1; worker < workers && worker < count; ++worker) {
    threads.emplace_back(go, worker);
  }
  go(0);
  threads.clear();  // joins the threads
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace talweg::driver

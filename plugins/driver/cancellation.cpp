#include "cancellation.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>

#include "commands.hpp"

namespace talweg::driver {
namespace {

using Clock = std::chrono::steady_clock;

// Time of the first signal; 0 if none came. Any thread may read it; it is lock-free for the signal
// handler.
std::atomic<std::int64_t> g_interrupted_at = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

extern "C" void on_interrupt(int /*signal*/) {
  const auto now = std::chrono::nanoseconds(Clock::now().time_since_epoch());
  std::int64_t first = 0;
  if (g_interrupted_at.compare_exchange_strong(first, now.count())) return;
  // timeout(1) and others send a signal twice in quick succession.
  if (now - std::chrono::nanoseconds(first) > std::chrono::milliseconds(500))
    std::_Exit(kCancelled);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  // A file that exceeds the size limit (ulimit -f) then gives a write error with a message.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return g_interrupted_at != 0; }

}  // namespace talweg::driver

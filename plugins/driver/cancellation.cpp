#include "cancellation.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>

#include "commands.hpp"
#include "console.hpp"

namespace talweg::driver {
namespace {

using Clock = std::chrono::steady_clock;

// The time of the first interrupt; 0 without an interrupt. Any thread may read the variable, which
// is lock-free for signal handlers.
std::atomic<std::int64_t> g_interrupted_at = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void on_interrupt() {
  const auto now = std::chrono::nanoseconds(Clock::now().time_since_epoch());
  std::int64_t first = 0;
  if (g_interrupted_at.compare_exchange_strong(first, now.count())) return;
  // timeout(1) and others send a signal twice in quick succession.
  if (now - std::chrono::nanoseconds(first) > std::chrono::milliseconds(500))
    std::_Exit(kCancelled);
}

}  // namespace

void catch_interrupts() { at_interrupts(on_interrupt); }

bool interrupted() { return g_interrupted_at != 0; }

}  // namespace talweg::driver

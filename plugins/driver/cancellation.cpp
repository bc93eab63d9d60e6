#include "cancellation.hpp"

#include <atomic>
#include <csignal>

namespace talweg::driver {
namespace {

// Any thread may ask; lock-free, so that a signal handler may set it.
std::atomic<bool> g_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_interrupt(int /*signal*/) { g_interrupted = true; }

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  // A file that grows beyond the limit (ulimit -f) is then an error of writing, with a sentence.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return g_interrupted; }

}  // namespace talweg::driver

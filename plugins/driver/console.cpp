#include "console.hpp"

#include <csignal>

#include <unistd.h>

namespace talweg::driver {
namespace {

void (*g_act)() = nullptr;

extern "C" void on_signal(int /*signal*/) { g_act(); }

}  // namespace

std::vector<std::string> command_line(int argc, char** argv) { return {argv, argv + argc}; }

bool is_terminal(std::FILE& stream) { return isatty(fileno(&stream)) != 0; }

void at_interrupts(void (*act)()) {
  g_act = act;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // A file that exceeds the size limit (ulimit -f) then gives a write error with a message.
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace talweg::driver

#include "progress_bar.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include <unistd.h>

#include "cancellation.hpp"

namespace talweg::driver {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWidth = 30;
constexpr auto kFirst = std::chrono::milliseconds(300);  // short work shows no bar at all
constexpr auto kEvery = std::chrono::milliseconds(50);

bool g_drawn = false;

void draw(const char* stage, double fraction) {
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kWidth - filled), '.');
  std::fprintf(stderr, "\r%-10s [%s] %3.0f %%", stage, bar.c_str(), 100 * fraction);
  std::fflush(stderr);
  g_drawn = true;
}

}  // namespace

Progress progress_bar(bool quiet) {
  const bool visible = !quiet && isatty(STDERR_FILENO) != 0;
  return [visible, next = Clock::now() + kFirst](const char* stage, double fraction) mutable {
    if (visible && Clock::now() >= next) {
      draw(stage, fraction);
      next = Clock::now() + kEvery;
    }
    return !interrupted();
  };
}

void clear_progress_bar() {
  if (!g_drawn) return;
  std::fprintf(stderr, "\r%*s\r", kWidth + 24, "");
  std::fflush(stderr);
  g_drawn = false;
}

}  // namespace talweg::driver

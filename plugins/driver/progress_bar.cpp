#include "progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <fmt/format.h>

#include "cancellation.hpp"
#include "console.hpp"

namespace talweg::driver {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kCells = 30;
constexpr auto kFirst = std::chrono::milliseconds(300);  // shorter work shows no bar
constexpr auto kEvery = std::chrono::milliseconds(50);

std::size_t g_drawn = 0;  // length of the line on the terminal

/// Replaces the line, and blanks the rest of a longer one.
void put_line(const std::string& line) {
  std::fprintf(stderr, "\r%-*s", static_cast<int>(g_drawn), line.c_str());
  std::fflush(stderr);
  g_drawn = std::max(g_drawn, line.size());
}

std::string bar(double fraction) {
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * kCells);
  return fmt::format("[{:#>{}}{:.>{}}] {:3.0f} %", "", filled, "", kCells - filled, 100 * fraction);
}

/// Formats a time: 1:05, 2:03:09.
std::string clock_text(double seconds) {
  const auto s = static_cast<std::int64_t>(std::ceil(seconds));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress progress_bar(bool quiet) {
  const bool visible = !quiet && is_terminal(*stderr);
  return [visible, next = Clock::now() + kFirst](const char* stage, double fraction) mutable {
    if (visible && Clock::now() >= next) {
      put_line(fmt::format("{:<10} {}", stage, bar(fraction)));
      next = Clock::now() + kEvery;
    }
    return !interrupted();
  };
}

std::string progress_text(std::size_t done, std::size_t failed, std::size_t total, double seconds) {
  std::string text = fmt::format("{}/{}", done, total);
  if (failed > 0) text += fmt::format(" ({} failed)", failed);
  if (done == 0 || seconds <= 0) return text;
  const double rate = static_cast<double>(done) / seconds;
  text += rate >= 1 ? fmt::format(", {:.3g}/s", rate) : fmt::format(", {:.3g} s each", 1 / rate);
  if (done == total) return text;
  return text + fmt::format(", {} left", clock_text(static_cast<double>(total - done) / rate));
}

CountedBar::CountedBar(std::size_t total, bool quiet)
    : total_(total), visible_(!quiet && is_terminal(*stderr)), next_(start_ + kFirst) {}

void CountedBar::done(bool failed) {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (failed) ++failed_;
  draw();
}

void CountedBar::tick() {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  draw();
}

void CountedBar::draw() {
  const auto now = Clock::now();
  if (!visible_ || now < next_) return;
  next_ = now + kEvery;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  put_line(bar(static_cast<double>(done_) / static_cast<double>(total_)) + " " +
           progress_text(done_, failed_, total_, seconds));
}

void clear_progress_bar() {
  if (g_drawn == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(g_drawn), "");
  std::fflush(stderr);
  g_drawn = 0;
}

}  // namespace talweg::driver

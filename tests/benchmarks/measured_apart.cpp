#include "measured_apart.hpp"

#include <cstdio>
#include <ctime>
#include <exception>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace talweg::benchmarks {
namespace {

[[noreturn]] void run_and_leave(const std::function<std::vector<double>()>& task, int to) {
  int code = 1;
  try {
    const std::vector<double> numbers = task();
    const auto* bytes = reinterpret_cast<const char*>(numbers.data());
    std::size_t left = numbers.size() * sizeof(double);
    while (left > 0) {
      const ssize_t written = write(to, bytes, left);
      if (written <= 0) break;
      bytes += written;
      left -= static_cast<std::size_t>(written);
    }
    code = left == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  std::fflush(nullptr);
  _exit(code);
}

}  // namespace

std::optional<Measured> measured_apart(const std::function<std::vector<double>()>& task) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    close(ends[0]);
    run_and_leave(task, ends[1]);
  }
  close(ends[1]);
  Measured measured;
  std::vector<char> bytes;
  char buffer[4096];
  for (ssize_t got = 0; (got = read(ends[0], buffer, sizeof buffer)) > 0;) {
    bytes.insert(bytes.end(), buffer, buffer + got);
  }
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  const auto* numbers = reinterpret_cast<const double*>(bytes.data());
  measured.numbers.assign(numbers, numbers + bytes.size() / sizeof(double));
  measured.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  return measured;
}

double mean_ms(int repeat, const std::function<void()>& call) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < repeat; ++i) call();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / repeat;
}

}  // namespace talweg::benchmarks

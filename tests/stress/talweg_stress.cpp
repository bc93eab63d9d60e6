// Random runs, as many as asked for: talweg-stress FIRST COUNT [THREADS].
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

#include "stress/random_run.hpp"

namespace {

char current[64];
int current_length = 0;

/// A crash, or a run that does not end: says which seed it was.
void on_signal(int signal) {
  [[maybe_unused]] const auto written =
      write(STDERR_FILENO, current, static_cast<std::size_t>(current_length));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

constexpr unsigned kLongestSeconds = 120;

}  // namespace

int main(int argc, char** argv) {
  using talweg::stress::RunOutcome;
  if (argc < 3) {
    std::fprintf(stderr, "usage: talweg-stress FIRST COUNT [THREADS]\n");
    return 1;
  }
  const auto first = std::strtoull(argv[1], nullptr, 10),
             count = std::strtoull(argv[2], nullptr, 10);
  const auto threads = static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 1);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGALRM}) std::signal(signal, on_signal);

  std::map<std::string, std::size_t> ends;
  struct Time {
    double seconds;
    unsigned long long seed;
    std::string what;
  };
  std::vector<Time> times;
  std::size_t broken = 0;
  std::uint64_t bytes = 0;
  double total = 0;
  for (auto seed = first; seed < first + count; ++seed) {
    current_length = std::snprintf(current, sizeof current, "in the run of seed %llu\n", seed);
    alarm(kLongestSeconds);
    const auto start = std::chrono::steady_clock::now();
    RunOutcome outcome;
    try {
      outcome = talweg::stress::random_run(seed, threads);
    } catch (const std::exception& error) {
      outcome.broken = std::string("thrown: ") + error.what();
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    total += seconds;
    if (outcome.end == RunOutcome::End::kSmoothed) times.push_back({seconds, seed, outcome.what});
    ends[outcome.end == RunOutcome::End::kSmoothed      ? "smoothed"
         : outcome.end == RunOutcome::End::kMeshRefused ? "mesh refused"
                                                        : "curve refused"] += 1;
    if (std::getenv("TALWEG_STRESS_VERBOSE") != nullptr) {
      std::printf("%llu %.3f s %s %s\n", seed, seconds, outcome.what.c_str(),
                  outcome.refusal.c_str());
    }
    if (!outcome.broken.empty()) {
      ++broken;
      std::printf("seed %llu: %s [%s] %s\n", seed, outcome.broken.c_str(), outcome.what.c_str(),
                  outcome.refusal.c_str());
      std::fflush(stdout);
    }
    bytes = bytes * 31 + outcome.bytes;
  }
  alarm(0);
  for (const auto& [end, number] : ends) std::printf("%s: %zu\n", end.c_str(), number);
  std::sort(times.begin(), times.end(),
            [](const Time& a, const Time& b) { return a.seconds < b.seconds; });
  if (!times.empty()) {
    const double median = times[times.size() / 2].seconds;
    const auto over = std::count_if(times.begin(), times.end(),
                                    [&](const Time& t) { return t.seconds > 10 * median; });
    std::printf("median %.1f ms, %td runs of more than 10 medians, the longest:\n", 1e3 * median,
                over);
    for (std::size_t k = times.size(); k > 0 && k + 5 > times.size(); --k) {
      const Time& t = times[k - 1];
      std::printf("  %.1f ms, seed %llu [%s]\n", 1e3 * t.seconds, t.seed, t.what.c_str());
    }
  }
  std::printf("broken: %zu, %.1f s, bytes %016llx\n", broken, total,
              static_cast<unsigned long long>(bytes));
  return broken == 0 ? 0 : 1;
}

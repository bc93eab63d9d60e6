// Random runs, as many as asked for: talweg-stress FIRST COUNT [THREADS].
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include <sys/time.h>
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

constexpr long kLongestSeconds = 120;  // of the processor

/// SIGPROF when the run has used that much; 0 for never.
void limit_time(long seconds) {
  const itimerval limit = {{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Of the processor, all threads: others may use the machine, too.
double seconds_used() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Time {
  double seconds, work;
  unsigned long long seed;
  std::string what;
};

template <class Value>
void print_longest(std::vector<Time> times, const char* unit, const Value& value) {
  if (times.empty()) return;
  std::sort(times.begin(), times.end(),
            [&](const Time& a, const Time& b) { return value(a) < value(b); });
  const double median = value(times[times.size() / 2]);
  const auto over = std::count_if(times.begin(), times.end(),
                                  [&](const Time& t) { return value(t) > 10 * median; });
  std::printf("%s: median %.4g, %td of more than 10 medians, the most:\n", unit, median, over);
  for (std::size_t k = times.size(); k > 0 && k + 5 > times.size(); --k) {
    const Time& t = times[k - 1];
    std::printf("  %.4g (%.4g s), seed %llu [%s]\n", value(t), t.seconds, t.seed, t.what.c_str());
  }
}

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
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGPROF}) std::signal(signal, on_signal);

  std::map<std::string, std::size_t> ends;
  std::vector<Time> times;
  std::size_t broken = 0, pieces = 0, lids = 0, lids_refused = 0;
  std::uint64_t bytes = 0;
  double total = 0;
  for (auto seed = first; seed < first + count; ++seed) {
    current_length = std::snprintf(current, sizeof current, "in the run of seed %llu\n", seed);
    limit_time(kLongestSeconds);
    const double start = seconds_used();
    RunOutcome outcome;
    try {
      outcome = talweg::stress::random_run(seed, threads);
    } catch (const std::exception& error) {
      outcome.broken = std::string("thrown: ") + error.what();
    }
    const double seconds = seconds_used() - start;
    total += seconds;
    if (outcome.end == RunOutcome::End::kSmoothed) {
      times.push_back({seconds, outcome.work, seed, outcome.what});
    }
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
    pieces += outcome.pieces;
    lids += outcome.lids;
    lids_refused += outcome.lids_refused;
    bytes = bytes * 31 + outcome.bytes;
  }
  limit_time(0);
  for (const auto& [end, number] : ends) std::printf("%s: %zu\n", end.c_str(), number);
  std::printf("pieces capped: %zu, by %zu lids; refused: %zu\n", pieces - lids_refused, lids,
              lids_refused);
  print_longest(times, "seconds", [](const Time& t) { return t.seconds; });
  print_longest(times, "seconds per million units of work",
                [](const Time& t) { return 1e6 * t.seconds / t.work; });
  std::printf("broken: %zu, %.1f s, bytes %016llx\n", broken, total,
              static_cast<unsigned long long>(bytes));
  return broken == 0 ? 0 : 1;
}

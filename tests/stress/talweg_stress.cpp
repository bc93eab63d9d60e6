// talweg-stress FIRST COUNT [THREADS] makes COUNT random runs. The seed of a run that fails or
// takes too long is printed.
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

using talweg::stress::RunOutcome;

char current[64];
int current_length = 0;

/// On a crash or a timeout, prints the seed.
void on_signal(int signal) {
  [[maybe_unused]] const auto written =
      write(STDERR_FILENO, current, static_cast<std::size_t>(current_length));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

constexpr long kLongestSeconds = 120;  // processor time

/// Raises SIGPROF after this processor time; 0 for never.
void limit_time(long seconds) {
  const itimerval limit = {{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Processor time of all threads, because other programs may use the machine.
double seconds_used() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs up to this time are never slow.
constexpr double kFreeSeconds = 1;

bool is_slow(double seconds, const RunOutcome& outcome) {
  return seconds > std::max(kFreeSeconds, outcome.most_seconds);
}

struct Time {
  double seconds, work, most_seconds;
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

/// Sums over all runs, and the faults of each run.
struct Tally {
  std::map<std::string, std::size_t> ends;
  std::vector<Time> times;
  std::size_t broken = 0, slow = 0;
  std::size_t pieces = 0, lids = 0, lids_refused = 0, budgets = 0, networks = 0, borders = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;

  void add(unsigned long long seed, double used, const RunOutcome& outcome);
  void print() const;
};

void Tally::add(unsigned long long seed, double used, const RunOutcome& outcome) {
  seconds += used;
  if (outcome.work > 0) {
    times.push_back({used, outcome.work, outcome.most_seconds, seed, outcome.what});
  }
  ends[outcome.end == RunOutcome::End::kSmoothed      ? "smoothed"
       : outcome.end == RunOutcome::End::kMeshRefused ? "mesh refused"
                                                      : "curve refused"] += 1;
  const auto report = [&](const std::string& what) {
    std::printf("seed %llu: %s [%s] %s\n", seed, what.c_str(), outcome.what.c_str(),
                outcome.refusal.c_str());
    std::fflush(stdout);
  };
  if (!outcome.broken.empty()) {
    ++broken;
    report(outcome.broken);
  }
  if (is_slow(used, outcome)) {
    ++slow;
    report("slow: " + std::to_string(used) + " s");
  }
  pieces += outcome.pieces;
  lids += outcome.lids;
  lids_refused += outcome.lids_refused;
  budgets += outcome.had_budget ? 1U : 0U;
  networks += outcome.borders > 0 ? 1U : 0U;
  borders += outcome.borders;
  bytes = bytes * 31 + outcome.bytes;
}

void Tally::print() const {
  for (const auto& [end, number] : ends) std::printf("%s: %zu\n", end.c_str(), number);
  std::printf("pieces capped: %zu, by %zu lids; refused: %zu\n", pieces - lids_refused, lids,
              lids_refused);
  std::printf("with a budget: %zu; label networks: %zu, of %zu borders\n", budgets, networks,
              borders);
  print_longest(times, "seconds", [](const Time& t) { return t.seconds; });
  print_longest(times, "seconds per million units of work",
                [](const Time& t) { return 1e6 * t.seconds / t.work; });
  print_longest(times, "of the seconds that it may take",
                [](const Time& t) { return t.seconds / std::max(kFreeSeconds, t.most_seconds); });
  std::printf("broken: %zu, slow: %zu, %.1f s, bytes %016llx\n", broken, slow, seconds,
              static_cast<unsigned long long>(bytes));
}

RunOutcome run(unsigned long long seed, unsigned threads) {
  current_length = std::snprintf(current, sizeof current, "in the run of seed %llu\n", seed);
  limit_time(kLongestSeconds);
  RunOutcome outcome;
  try {
    outcome = talweg::stress::random_run(seed, threads);
  } catch (const std::exception& error) {
    outcome.broken = std::string("thrown: ") + error.what();
  }
  limit_time(0);
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: talweg-stress FIRST COUNT [THREADS]\n");
    return 1;
  }
  const auto first = std::strtoull(argv[1], nullptr, 10),
             count = std::strtoull(argv[2], nullptr, 10);
  const auto threads = static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 1);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGPROF}) std::signal(signal, on_signal);

  Tally tally;
  for (auto seed = first; seed < first + count; ++seed) {
    double start = seconds_used();
    const RunOutcome outcome = run(seed, threads);
    double seconds = seconds_used() - start;
    if (is_slow(seconds, outcome)) {  // the machine may have been slow, so the run is repeated
      start = seconds_used();
      run(seed, threads);
      seconds = std::min(seconds, seconds_used() - start);
    }
    if (std::getenv("TALWEG_STRESS_VERBOSE") != nullptr) {
      std::printf("%llu %.3f s %s %s\n", seed, seconds, outcome.what.c_str(),
                  outcome.refusal.c_str());
    }
    tally.add(seed, seconds, outcome);
  }
  tally.print();
  return tally.broken + tally.slow == 0 ? 0 : 1;
}

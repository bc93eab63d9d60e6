// Measurements run in processes of their own, so that each has its own peak of memory.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace talweg::benchmarks {

struct Measured {
  std::vector<double> numbers;  ///< what the task returned
  double peak_mib = 0;          ///< resident memory at its highest
};

/// Runs the task in a forked process; nothing when it failed (it has said why on stderr). Fork
/// before this process has threads or much memory.
std::optional<Measured> measured_apart(const std::function<std::vector<double>()>& task);

/// Processor time of `call` in ms, the mean of `repeat` calls. Beside other programs, processor
/// time tells more than a clock does.
double mean_ms(int repeat, const std::function<void()>& call);

}  // namespace talweg::benchmarks

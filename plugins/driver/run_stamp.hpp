// Stamps of a run show whether a new run would repeat an earlier one.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "smooth_options.hpp"

namespace talweg::driver {

/// Hashes of the inputs of runs. May be used from any thread.
class InputStamps {
 public:
  /// A hash of the program's version, of all options that can change a result, and of the contents
  /// and name endings of the files that the run reads. Empty when a file cannot be read, or is a
  /// pipe, which can be read only once. Hashes of files are cached.
  std::string of(const SmoothOptions& options);

 private:
  std::string of_file(const std::string& path);

  std::mutex mutex_;
  std::map<std::string, std::string> files_;
};

/// A hash of the curves that a run has written. The report contains times, so only its existence
/// counts. Empty when an output is missing or is not a file.
std::string outputs_stamp(const SmoothOptions& options);

}  // namespace talweg::driver

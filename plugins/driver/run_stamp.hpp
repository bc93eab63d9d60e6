// Stamps tell whether a run would do again what an earlier one did.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "smooth_options.hpp"

namespace talweg::driver {

/// Hashes of what runs are made from. May be used from any thread.
class InputStamps {
 public:
  /// A hash of the program's version, of all options that can change a result, and of the contents
  /// of the files that the run reads; their names do not matter, but their endings do. Empty when a
  /// file cannot be read, or is a pipe, which can be read only once.
  /// What a file's hash was is kept.
  std::string of(const SmoothOptions& options);

 private:
  std::string of_file(const std::string& path);

  std::mutex mutex_;
  std::map<std::string, std::string> files_;
};

/// A hash of the curves that a run has written. A report has times in it, so it need only be there.
/// Empty when an output is missing or is no file.
std::string outputs_stamp(const SmoothOptions& options);

}  // namespace talweg::driver

// An output of the driver is a file, the standard output or a pipe.
#pragma once

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "in_place.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

/// "-" is the standard output; so is "-.vtp", whose ending chooses the format as a file's does.
bool is_standard_output(std::string_view path);

/// Writes a file as write_file() does, or the standard output; a pipe waits for its reader.
/// Throws Error(kBadFile) naming path and reason, and WaitCancelled.
void write_output(const std::string& path, std::string_view bytes);

/// Writes several outputs. If one output fails, the others are still written, so no result of a
/// long run is lost.
class OutputAttempts {
 public:
  /// Runs `write` and keeps the first Error.
  template <class Write>
  void make(const Write& write) {
    try {
      write();
    } catch (const Error&) {
      if (!failure_) failure_ = std::current_exception();
    }
  }
  /// Throws the first Error, if any.
  void finish() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
};

/// The stream for text for people: the standard output, unless an output uses it.
std::FILE* text_stream();
/// From now on text for people goes to the standard error.
void keep_text_from_standard_output();

}  // namespace talweg::driver

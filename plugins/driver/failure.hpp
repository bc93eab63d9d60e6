// A failure is what an exception means to the user: an exit code and a sentence.
#pragma once

#include <string>

namespace talweg::driver {

struct Failure {
  int code = 0;
  std::string message;
};

/// Describes the exception that is being handled; to be called in a catch clause.
Failure current_failure();

}  // namespace talweg::driver

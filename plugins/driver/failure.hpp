// A failure is what an exception means to the user: an exit code and a sentence.
#pragma once

#include <string>

namespace talweg::driver {

struct Failure {
  int code = 0;
  std::string message;
};

/// Of the exception that is being handled; call it in a catch clause.
Failure current_failure();

}  // namespace talweg::driver

// A driver run is made in a folder of its own, as a user would.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/temporary_folder.hpp"
#include "places.hpp"

namespace talweg::test {

class DriverRuns : public TemporaryFolder {
 protected:
  struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
  };

  /// `before`: what the shell does first, such as "ulimit -v 100000".
  [[nodiscard]] Outcome run(const std::string& arguments, const std::string& before = ":") const {
    std::string command("cd '");
    command.append(file("").string()).append("' && ").append(before);
    command.append(" && '").append(driver_program()).append("' ").append(arguments);
    command.append(" >out.log 2>err.log </dev/null");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(file("out.log")),
            bytes_of(file("err.log"))};
  }

  /// Fails with this code, one line on stderr besides warnings, with these words, and nothing on
  /// stdout.
  void expect_failure(const std::string& arguments, int code,
                      std::initializer_list<const char*> words) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    std::istringstream lines(outcome.err);
    std::size_t failures = 0;
    for (std::string line; std::getline(lines, line);) {
      failures += static_cast<std::size_t>(!line.starts_with("talweg: warning: "));
    }
    EXPECT_EQ(failures, 1U) << outcome.err;
    for (const char* word : words)
      EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }
};

}  // namespace talweg::test

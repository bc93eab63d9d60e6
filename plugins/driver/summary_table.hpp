// The summary table has the reports of many curves, one a line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "talweg/core/measure/report.hpp"

namespace talweg::driver {

/// Comma-separated, one line per curve, quoted as in RFC 4180. The columns are `line mesh curve
/// number status message` and the report's names, without times and memory, so that equal results
/// give equal tables. `status` is the report's termination, "failed" or "cancelled".
class SummaryTable {
 public:
  struct Place {
    std::size_t line = 0;  ///< line in the list; 0 without a list
    std::string mesh;
    std::string curve;
  };

  SummaryTable();
  void add(const Place& place, std::size_t number, const SmoothingReport& report);
  /// Adds a curve without a result; an empty number means all curves of the run.
  void add(const Place& place, const std::string& number, std::string_view status,
           std::string_view message);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t columns_ = 0;  ///< number of report columns
};

}  // namespace talweg::driver

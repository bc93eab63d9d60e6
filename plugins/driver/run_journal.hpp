// The journal of a list of runs keeps the rows of each run as soon as the run ends, so that a
// killed program can be resumed.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "summary_table.hpp"
#include "talweg/core/system/files.hpp"

namespace talweg::driver {

/// The journal lies beside the summary, with `.part` appended to its name; rows have the same form
/// in both.
class RunJournal {
 public:
  /// With `resume`, reads the rows of summary and journal and keeps them in the new journal. Throws
  /// Error(kBadFile) when one of the files cannot be read, or the journal cannot be written.
  RunJournal(std::string summary, bool resume);
  RunJournal(const RunJournal&) = delete;
  RunJournal& operator=(const RunJournal&) = delete;

  /// The run with these stamps that an earlier program finished without a failure; nullptr if no
  /// such run exists.
  [[nodiscard]] const SummaryRun* earlier(const std::string& inputs,
                                          const std::string& outputs) const;
  /// Why no rows of an earlier table can be kept; empty where rows can be kept.
  [[nodiscard]] const std::string& other_table() const { return other_table_; }

  /// Adds a finished run. May be called from any thread.
  void add(const SummaryRun& run);
  /// Removes the journal, to be called after the summary was written.
  void close();

 private:
  void read(const std::string& path);

  std::string summary_, path_, other_table_;
  std::map<std::pair<std::string, std::string>, SummaryRun> earlier_;
  std::mutex mutex_;
  File file_;
};

/// The name of the journal of a summary; empty for a summary that is a pipe or has no name.
std::string journal_of(const std::string& summary);

}  // namespace talweg::driver

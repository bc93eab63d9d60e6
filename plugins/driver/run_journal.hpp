// The journal of many runs keeps each one's rows as soon as it is done, so that a killed program
// can go on.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "summary_table.hpp"
#include "talweg/core/system/files.hpp"

namespace talweg::driver {

/// Beside the summary, with `.part` behind its name; what is in both has the same form.
class RunJournal {
 public:
  /// With `resume` reads what summary and journal have, and keeps it in the new journal. Throws
  /// Error(kBadFile) when they cannot be read, or the journal cannot be written.
  RunJournal(std::string summary, bool resume);
  RunJournal(const RunJournal&) = delete;
  RunJournal& operator=(const RunJournal&) = delete;

  /// The run with these stamps that an earlier program finished, without a failure; nullptr if none
  /// did.
  [[nodiscard]] const SummaryRun* earlier(const std::string& inputs,
                                          const std::string& outputs) const;
  /// Why nothing can be taken from an earlier table; empty where it can.
  [[nodiscard]] const std::string& other_table() const { return other_table_; }

  /// Adds a run that is done. May be called from any thread.
  void add(const SummaryRun& run);
  /// The summary stands: the journal is removed.
  void close();

 private:
  void read(const std::string& path);

  std::string summary_, path_, other_table_;
  std::map<std::pair<std::string, std::string>, SummaryRun> earlier_;
  std::mutex mutex_;
  File file_;
};

/// The name of the journal of a summary; empty for a summary that is no file, but a pipe or
/// nothing.
std::string journal_of(const std::string& summary);

}  // namespace talweg::driver

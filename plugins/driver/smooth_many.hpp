// `talweg smooth` does many runs, several at a time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "commands.hpp"
#include "run_list.hpp"

namespace talweg::driver {

struct ManyOptions {
  std::string list;      ///< name of the list, for messages
  std::string summary;   ///< table of all reports; none if empty
  bool resume = false;   ///< keep finished runs of the summary and its journal (needs `summary`)
  std::size_t jobs = 1;  ///< number of runs at a time, and limit of meshes open at a time
};

/// Does all runs, even if some fail, and reports failures at the end: lines on stderr, and the
/// summary. Every mesh is opened once; outputs are the same bytes for any number of jobs. Returns
/// the exit code of the worst outcome.
int smooth_many(std::vector<ListedRun> runs, const ManyOptions& options,
                const GlobalOptions& global);

}  // namespace talweg::driver

// `talweg smooth` does many runs, several at a time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "commands.hpp"
#include "run_list.hpp"

namespace talweg::driver {

struct ManyOptions {
  std::string list;      ///< its name, for messages
  std::string summary;   ///< table of all reports; none where empty
  std::size_t jobs = 1;  ///< runs at a time, and the most meshes open at a time
};

/// Runs them all, whatever becomes of one, and says at the end what failed: lines on stderr, and
/// the summary. Every mesh is opened once; outputs are the same bytes for any number of jobs.
/// Returns the exit code of the worst outcome.
int smooth_many(std::vector<ListedRun> runs, const ManyOptions& options,
                const GlobalOptions& global);

}  // namespace talweg::driver

// Outputs to a pipe, a terminal or a device are written in place. Regular files are replaced as a
// whole instead (write_file()).
#pragma once

#include <string>
#include <string_view>

#include "talweg/core/system/files.hpp"

namespace talweg::driver {

/// Thrown if a signal came while an output waited for its reader.
struct WaitCancelled {
  std::string path;
};

/// Both throw Error(kBadFile) naming the output and the reason, and WaitCancelled. A pipe waits for
/// its reader.
void write_in_place(const std::string& path, FileKind kind, std::string_view bytes);
void write_standard_output(std::string_view bytes);

}  // namespace talweg::driver

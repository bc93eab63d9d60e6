// The file of a shared library, before the system loads it.
#pragma once

#include <string>

namespace talweg::loader {

/// Throws std::runtime_error with one sentence if the path is not a file, if the file is not a
/// shared library of this system, or if it ends too early (checked where the system's loader would
/// crash the program).
void check_library_file(const std::string& path);

}  // namespace talweg::loader

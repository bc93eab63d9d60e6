// The file of a shared library, before the system loads it.
#pragma once

#include <string>

namespace talweg::loader {

/// Throws std::runtime_error with one sentence if the file is none, is no shared library of this
/// system or (where the system's loader would crash the program) ends too early.
void check_library_file(const std::string& path);

}  // namespace talweg::loader

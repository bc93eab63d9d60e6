// The search path: the folders with plugins (talweg_loader.h).
#pragma once

#include <string>
#include <vector>

namespace talweg::loader {

/// Splits "a:b" (on Windows "a;b") into its folders; empty ones are left out.
std::vector<std::string> split(const std::string& folders);

/// The folders from the environment, those relative to the program, and the installed one, without
/// duplicates.
std::vector<std::string> standard_folders();

}  // namespace talweg::loader

// The search path is where plugins are looked for (talweg_loader.h).
#pragma once

#include <string>
#include <vector>

namespace talweg::loader {

/// "a:b" as its folders; empty ones are left out.
std::vector<std::string> split(const std::string& folders);

/// The environment's folders, those seen from the program, the installed one; each once.
std::vector<std::string> standard_folders();

}  // namespace talweg::loader

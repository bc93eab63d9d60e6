// The version is that of the library.
#pragma once

namespace talweg {

/// The library's version, "major.minor.patch".
const char* version();

}  // namespace talweg

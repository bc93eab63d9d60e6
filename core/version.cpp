#include "talweg/core/version.hpp"

namespace talweg {

const char* version() { return TALWEG_VERSION; }

}  // namespace talweg

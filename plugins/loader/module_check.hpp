// The module check tells whether a loaded library is a plugin that this host can use.
#pragma once

#include <string>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::loader {

/// Empty if a host of this interface version can use the module and everything that it describes is
/// present; otherwise one sentence that says what is wrong. `module` may be null.
std::string objection(const talweg_module* module, std::uint32_t host_major,
                      std::uint32_t host_minor);

}  // namespace talweg::loader

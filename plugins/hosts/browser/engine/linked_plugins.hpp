// The plugins that are linked into the engine.
#pragma once

#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

const editing::Plugins& linked_plugins();

}  // namespace talweg::browser

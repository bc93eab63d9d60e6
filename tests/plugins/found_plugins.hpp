// The plugins of this build, for tests of what hosts share.
#pragma once

#include "talweg/editing/workplace.hpp"

namespace talweg::test {

inline const editing::Plugins& found_plugins() {
  static const editing::Plugins plugins(TALWEG_PLUGINS);
  return plugins;
}

}  // namespace talweg::test

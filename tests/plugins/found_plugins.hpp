// The plugins of this build, for tests of what hosts share.
#pragma once

#include "places.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::test {

inline const editing::Plugins& found_plugins() {
  static const editing::Plugins plugins(test::plugin_folder());
  return plugins;
}

}  // namespace talweg::test

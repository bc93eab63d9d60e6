// The description of the plugin's functions for the host's script window.
#pragma once

#include <QString>
#include <vector>

namespace talweg::openflipper {

struct ScriptSlot {
  const char* slot;
  QString what;
  const char* parameters;  ///< names and meanings, separated by ';'
  QString meanings;
};

std::vector<ScriptSlot> script_help();

}  // namespace talweg::openflipper

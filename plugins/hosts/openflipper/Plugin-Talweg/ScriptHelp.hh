// The script help is what the host's script window says of the plugin's functions.
#pragma once

#include <QString>
#include <vector>

namespace talweg::openflipper {

struct ScriptSlot {
  const char* slot;
  QString what;
  const char* parameters;  ///< separated by ';', as their meanings
  QString meanings;
};

std::vector<ScriptSlot> script_help();

}  // namespace talweg::openflipper

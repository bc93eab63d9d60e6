// Texts of ParaView's properties.
#pragma once

#include <string>

namespace talweg::paraview {

inline std::string text_of(const char* text) { return text == nullptr ? "" : text; }

/// The name of an array; empty for "None".
inline std::string array_name(const char* text) {
  const std::string name = text_of(text);
  return name == "None" ? "" : name;
}

}  // namespace talweg::paraview

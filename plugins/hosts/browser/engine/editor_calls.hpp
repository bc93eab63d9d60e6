// Calls of the page's editor.
#pragma once

#include <string>

#include "answer.hpp"
#include "talweg/editing/editor.hpp"

namespace talweg::browser {

/// Does one edit by its name in src/engine/editor.ts, with its arguments in order. Throws
/// editing::Error if the editor refuses the edit.
Answer call_editor(editing::Editor& editor, const std::string& name, const Json& arguments);

}  // namespace talweg::browser

// Calls of the page's editor.
#pragma once

#include <string>

#include "answer.hpp"
#include "talweg/editing/editor.hpp"

namespace talweg::browser {

/// Does one edit by its name in src/engine/editor.ts, with its arguments in order. Throws
/// editing::Error for one that cannot be done.
Answer call_editor(editing::Editor& editor, const std::string& name, const Json& arguments);

}  // namespace talweg::browser

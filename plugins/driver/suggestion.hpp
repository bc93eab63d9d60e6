// A suggestion is the known word most similar to a misspelt word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace talweg::driver {

/// "; did you mean WORD?" for the nearest known word: it begins with the written one, or one or two
/// letters are wrong, missing, superfluous or exchanged. Empty if there is none.
std::string suggestion(std::string_view written, std::span<const std::string> known);

}  // namespace talweg::driver

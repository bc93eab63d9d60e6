// A suggestion is the known word most similar to a misspelt word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace talweg::driver {

/// "; did you mean WORD?" for the nearest known word. A word is near if it begins with the written
/// word (of three letters or more), or differs from it by one letter (two, if the written word has
/// five or more) that is wrong, missing, superfluous or exchanged. Empty if no known word is near.
/// Leading hyphens do not count.
std::string suggestion(std::string_view written, std::span<const std::string> known);

}  // namespace talweg::driver

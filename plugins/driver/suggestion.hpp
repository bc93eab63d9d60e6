// A suggestion is the known word most similar to a misspelt word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace talweg::driver {

/// "; did you mean WORD?" for the nearest known word that begins with the written word, or differs
/// from it by one or two letters that are wrong, missing, superfluous or exchanged. Empty if no
/// known word is near.
std::string suggestion(std::string_view written, std::span<const std::string> known);

}  // namespace talweg::driver

// A suggestion is what a misspelt word was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace talweg::driver {

/// "; did you mean WORD?" for the known word that is nearest: it begins with what was written, or
/// one or two letters are wrong, missing, too many or exchanged. Empty where there is none.
std::string suggestion(std::string_view written, std::span<const std::string> known);

}  // namespace talweg::driver

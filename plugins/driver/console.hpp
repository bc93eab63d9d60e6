// The console gives the command line's words, shows text, and reports Ctrl-C.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace talweg::driver {

/// The words of the command line in UTF-8, the program's name first. From here on text in UTF-8 is
/// shown as such, and line ends are written as they are.
std::vector<std::string> command_line(int argc, char** argv);

bool is_terminal(std::FILE& stream);

/// `act` is called at every Ctrl-C or request to end, on any thread or in a signal handler.
void at_interrupts(void (*act)());

}  // namespace talweg::driver

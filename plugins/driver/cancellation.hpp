// Cancellation by Ctrl-C ends the work in order: nothing half-written, exit code 4.
#pragma once

namespace talweg::driver {

/// After this call the first Ctrl-C or request to end only raises the flag below; another one, half
/// a second later or more, ends the process at once.
void catch_interrupts();
bool interrupted();

}  // namespace talweg::driver

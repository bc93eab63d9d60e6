// Cancellation by Ctrl-C ends the work in order: nothing half-written, exit code 4.
#pragma once

namespace talweg::driver {

/// From now on the first SIGINT or SIGTERM only raises the flag below; another one, half a second
/// later or more, ends the process at once. SIGXFSZ ends nothing.
void catch_interrupts();
bool interrupted();

}  // namespace talweg::driver

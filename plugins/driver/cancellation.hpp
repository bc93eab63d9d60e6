// Ctrl-C ends the work in order: nothing half-written, exit code 4.
#pragma once

namespace talweg::driver {

/// From now on SIGINT and SIGTERM only raise the flag below, and SIGXFSZ ends nothing.
void catch_interrupts();
bool interrupted();

}  // namespace talweg::driver

// SIGINT and SIGTERM as a question that long work asks itself.
#pragma once

namespace packstone::cli {

/// From now on the signals only set a flag; a second one ends the program at once.
void catch_interrupts();

/// Whether a signal has come.
bool interrupted();

}  // namespace packstone::cli

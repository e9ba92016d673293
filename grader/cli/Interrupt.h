#ifndef TICKER_CLI_INTERRUPT_H
#define TICKER_CLI_INTERRUPT_H

#include <atomic>

namespace ticker::cli {

/// Installs signal handlers: the first Ctrl-C (or SIGTERM) sets the returned flag and prints a line
/// on stderr; a second one ends the program at once, with exit status 130.
[[nodiscard]] const std::atomic<bool>& catchInterrupts();

}  // namespace ticker::cli

#endif

#ifndef TICKER_CLI_INTERRUPT_H
#define TICKER_CLI_INTERRUPT_H

#include <atomic>

namespace ticker::cli {

/// From now on the first Ctrl-C (or SIGTERM) only sets the flag that is returned, and says so on
/// stderr; a second one ends the program at once, with exit status 130.
[[nodiscard]] const std::atomic<bool>& catchInterrupts();

}  // namespace ticker::cli

#endif

#ifndef TICKER_SANDBOX_JAIL_SYSTEMCALLS_H
#define TICKER_SANDBOX_JAIL_SYSTEMCALLS_H

#include <span>

namespace ticker::jail {

/// Numbers of system calls, as libseccomp writes them: those that Policy::run lets through, and
/// those that end a program. All others are refused.
[[nodiscard]] std::span<const int> allowedInRun();
[[nodiscard]] std::span<const int> killedInRun();

/// Those that Policy::compile refuses; all others are let through.
[[nodiscard]] std::span<const int> refusedInCompile();

}  // namespace ticker::jail

#endif

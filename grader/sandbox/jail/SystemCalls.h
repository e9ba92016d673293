#ifndef TICKER_SANDBOX_JAIL_SYSTEMCALLS_H
#define TICKER_SANDBOX_JAIL_SYSTEMCALLS_H

#include <span>

namespace ticker::jail {

/// System call numbers, in libseccomp's notation: those that Policy::run allows, and those that
/// kill the program. All others fail with an error.
[[nodiscard]] std::span<const int> allowedInRun();
[[nodiscard]] std::span<const int> killedInRun();

/// Those that Policy::compile refuses; all others are allowed.
[[nodiscard]] std::span<const int> refusedInCompile();

}  // namespace ticker::jail

#endif

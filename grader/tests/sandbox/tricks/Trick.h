#ifndef TICKER_TESTS_SANDBOX_TRICK_H
#define TICKER_TESTS_SANDBOX_TRICK_H

#include <span>

// The actions of hostile and of ordinary programs. A trick that is refused with an error, not ended
// by a signal, reports that with its exit status, see below.
namespace tricks {

inline constexpr int kRefused = 40;    ///< the system said no
inline constexpr int kSucceeded = 66;  ///< the trick worked: the jail leaks

struct Trick {
    const char* name;
    int (*run)(std::span<char*> arguments);
};

/// Ordinary actions that must keep working.
[[nodiscard]] std::span<const Trick> honest();
/// Exhausts time, memory, processes, output, files.
[[nodiscard]] std::span<const Trick> greedy();
/// Tries to access processes, files, the network, the kernel.
[[nodiscard]] std::span<const Trick> prying();

}  // namespace tricks

#endif

#ifndef RAYTRACER_APP_VIEW_GUARD_H
#define RAYTRACER_APP_VIEW_GUARD_H

#ifndef _WIN32
#include "process/Process.h"

#include <array>
#include <csignal>

namespace raytracer::view {

inline constexpr int kKilled = 128 + SIGKILL;

/// Call in a process that was just forked. Puts the pipes in place, starts the program and guards
/// it until it ends, or until nothing holds the other end of the lifeline. Then ends everything
/// that the program started.
/// @param ends  Ends of pipes: stdin, stdout and stderr of the program, and the lifeline.
[[noreturn]] void becomeGuard(char* const* command, const std::array<int, 4>& ends);

/// Takes the next number off a list, "12 345 ", as the system writes one: a blank follows each.
/// @return -1 at the end, and at a number without its blank: a buffer that was too small cut it.
[[nodiscard]] long takeWholeNumber(const char*& list);

/// Closes this file and all after it.
void closeFrom(int first);

/// Exit status from what waitpid says; above 128: the number of a signal.
[[nodiscard]] int statusOf(int status);

}  // namespace raytracer::view
#endif

#endif

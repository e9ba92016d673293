#ifndef TICKER_SANDBOX_JAIL_ENDALL_H
#define TICKER_SANDBOX_JAIL_ENDALL_H

#include <sys/types.h>

namespace ticker::jail {

/// Sends SIGKILL to what descends from the caller: as the first process of a pid namespace to all,
/// else to all of the uid `user` if that is not -1, else to the process group `group` and to the
/// caller's children. Reaps nothing.
void killAll(pid_t group, long user);

/// killAll and reap, until nothing is left.
void endAll(pid_t group, long user);

}  // namespace ticker::jail

#endif

#ifndef TICKER_SANDBOX_JAIL_ENDALL_H
#define TICKER_SANDBOX_JAIL_ENDALL_H

#include <sys/types.h>

namespace ticker::jail {

/// Sends SIGKILL to all descendants of the caller. As the first process of a pid namespace: to all
/// processes in it. Otherwise to all processes of the uid `user` if that is not -1, else to the
/// process group `group` and to the caller's children. Reaps none of them.
void killAll(pid_t group, long user);

/// Kills and reaps until no descendant is left.
void endAll(pid_t group, long user);

}  // namespace ticker::jail

#endif

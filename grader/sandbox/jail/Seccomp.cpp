#include <grader/sandbox/jail/Lockdown.h>
#include <grader/sandbox/jail/SystemCalls.h>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <span>

namespace ticker::jail {
namespace {

constexpr std::uint64_t kNamespaces[] = {CLONE_NEWUSER, CLONE_NEWNS,  CLONE_NEWPID,   CLONE_NEWNET,
                                         CLONE_NEWIPC,  CLONE_NEWUTS, CLONE_NEWCGROUP};

// Skips system calls that this machine's architecture does not have.
bool add(scmp_filter_ctx filter, std::uint32_t action, std::span<const int> calls) {
    for (const int call : calls) {
        const int result = seccomp_rule_add_array(filter, action, call, 0, nullptr);
        if (result != 0 && result != -EDOM) return false;
    }
    return true;
}

scmp_arg_cmp equals(unsigned argument, std::uint64_t value) {
    return {argument, SCMP_CMP_EQ, value, 0};
}

scmp_arg_cmp masked(unsigned argument, std::uint64_t mask, std::uint64_t value) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

bool addIf(scmp_filter_ctx filter, std::uint32_t action, int call, scmp_arg_cmp condition) {
    return seccomp_rule_add_array(filter, action, call, 1, &condition) == 0;
}

// Matches SIGKILL as the kernel reads it: the lower half of the argument.
scmp_arg_cmp isSigkill() {
    constexpr unsigned kSignalOfTgkill = 2;
    return masked(kSignalOfTgkill, 0xffffffffU, SIGKILL);
}

struct Bits {
    std::uint64_t mask;
    std::uint64_t value;
};

// The signals 0 to 64 without SIGKILL. The masks compare all 64 bits, so that no number that the
// kernel cuts down to SIGKILL is among them.
constexpr Bits kOwnSignals[] = {{~7ULL, 0},   {~0ULL, 8},   {~1ULL, 10}, {~3ULL, 12},
                                {~15ULL, 16}, {~31ULL, 32}, {~0ULL, 64}};

// abort() and raise() signal the process itself, which SIGKILL must not do: a SIGKILL that the
// helper did not send then comes from outside of the jail, and is not the program's failure.
bool addOwnSignals(scmp_filter_ctx filter) {
    bool added = addIf(filter, SCMP_ACT_KILL_PROCESS, SCMP_SYS(tgkill), isSigkill());
    for (const Bits& signals : kOwnSignals) {
        const scmp_arg_cmp both[] = {equals(0, static_cast<std::uint64_t>(getpid())),
                                     masked(2, signals.mask, signals.value)};
        added =
            added && seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), 2, both) == 0;
    }
    return added;
}

scmp_filter_ctx makeRunFilter() {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (filter == nullptr) return nullptr;
    constexpr std::uint64_t kThread = CLONE_THREAD | CLONE_VM;
    const bool added =
        add(filter, SCMP_ACT_ALLOW, allowedInRun()) &&
        add(filter, SCMP_ACT_KILL_PROCESS, killedInRun()) &&
        // Reading limits is allowed, changing them is not.
        addIf(filter, SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), equals(2, 0)) &&
        // fdopen() asks for the mode of a descriptor.
        addIf(filter, SCMP_ACT_ALLOW, SCMP_SYS(fcntl), equals(1, F_GETFL)) &&
        addOwnSignals(filter) &&
        addIf(filter, SCMP_ACT_ALLOW, SCMP_SYS(clone), masked(0, kThread, kThread)) &&
        addIf(filter, SCMP_ACT_KILL_PROCESS, SCMP_SYS(clone), masked(0, CLONE_THREAD, 0)) &&
        // The flags of clone3 lie in memory, where a filter cannot see them; on ENOSYS the C
        // library falls back to clone.
        seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0, nullptr) == 0;
    if (added) return filter;
    seccomp_release(filter);
    return nullptr;
}

scmp_filter_ctx makeCompileFilter() {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    if (filter == nullptr) return nullptr;
    constexpr std::uint32_t kRefuse = SCMP_ACT_ERRNO(EPERM);
    bool added =
        add(filter, kRefuse, refusedInCompile()) &&
        addIf(filter, kRefuse, SCMP_SYS(tgkill), isSigkill()) &&
        seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0, nullptr) == 0;
    for (const std::uint64_t space : kNamespaces)
        added = added && addIf(filter, kRefuse, SCMP_SYS(clone), masked(0, space, space));
    // TIOCSTI and TIOCLINUX inject input into a terminal.
    for (const std::uint64_t request : {std::uint64_t{TIOCSTI}, std::uint64_t{TIOCLINUX}})
        added = added && addIf(filter, kRefuse, SCMP_SYS(ioctl), masked(1, 0xffffffffU, request));
    if (added) return filter;
    seccomp_release(filter);
    return nullptr;
}

}  // namespace

Failure restrictSystemCalls(Filter which) {
    if (which == Filter::none) return nullptr;
    scmp_filter_ctx filter = which == Filter::run ? makeRunFilter() : makeCompileFilter();
    if (filter == nullptr) return "seccomp rules";
    const bool loaded =
        seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0 &&
        seccomp_attr_set(filter, SCMP_FLTATR_CTL_OPTIMIZE, 2) == 0 && seccomp_load(filter) == 0;
    seccomp_release(filter);
    return loaded ? nullptr : "seccomp";
}

}  // namespace ticker::jail

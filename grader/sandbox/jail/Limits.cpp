#include <grader/sandbox/jail/Lockdown.h>

#include <sys/resource.h>

#include <cstdint>

namespace ticker::jail {
namespace {

bool setLimit(__rlimit_resource resource, std::uint64_t soft, std::uint64_t hard) {
    const rlimit limit{soft, hard};
    return setrlimit(resource, &limit) == 0;
}

// A value of 0 leaves the limit unchanged.
bool setLimit(__rlimit_resource resource, std::uint64_t value) {
    return value == 0 || setLimit(resource, value, value);
}

// SIGXCPU can be caught. SIGKILL follows one second later and cannot; a program under Filter::run
// gets it from the helper instead (Supervise.cpp): who sends each SIGKILL is then known.
bool limitCpu(const Options& options) {
    const std::uint64_t cpu = options.cpuSeconds;
    rlimit inherited{};
    if (cpu == 0) return true;
    if (options.filter != Filter::run) return setLimit(RLIMIT_CPU, cpu, cpu + 1);
    return getrlimit(RLIMIT_CPU, &inherited) == 0 && setLimit(RLIMIT_CPU, cpu, inherited.rlim_max);
}

}  // namespace

Failure limitResources(const Options& options) {
    const bool basics = setLimit(RLIMIT_CORE, 0, 0) && setLimit(RLIMIT_MEMLOCK, 0, 0) &&
                        setLimit(RLIMIT_MSGQUEUE, 0, 0) && setLimit(RLIMIT_SIGPENDING, 64, 64);
    if (!basics) return "setrlimit";
    if (!limitCpu(options)) return "setrlimit cpu";
    if (!setLimit(RLIMIT_NOFILE, options.openFiles)) return "setrlimit open files";
    if (!setLimit(RLIMIT_STACK, options.stackBytes)) return "setrlimit stack";
    if (!setLimit(RLIMIT_FSIZE, options.fileSizeBytes)) return "setrlimit file size";
    if (!setLimit(RLIMIT_NPROC, options.processes)) return "setrlimit processes";
    if (!setLimit(RLIMIT_AS, options.addressSpaceBytes)) return "setrlimit address space";
    return nullptr;
}

}  // namespace ticker::jail

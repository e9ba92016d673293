#include "Trick.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace tricks {
namespace {

[[noreturn]] void spin() {
    volatile unsigned counter = 0;
    while (true)
        counter = counter + 1;
}

int loop(std::span<char*>) {
    spin();
}

int busyThreads(std::span<char*>) {
    std::vector<std::jthread> workers;
    for (int i = 0; i < 4; ++i)
        workers.emplace_back(spin);
    return 0;
}

int ignoreCpuLimit(std::span<char*>) {
    std::signal(SIGXCPU, SIG_IGN);
    spin();
}

int ignoreCpuLimitInThreads(std::span<char*> arguments) {
    std::signal(SIGXCPU, SIG_IGN);
    return busyThreads(arguments);
}

int blockAllSignals(std::span<char*>) {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, nullptr);
    spin();
}

void fault(int) {
    // Returns to the same faulting instruction.
}

int segvHandlerLoop(std::span<char*>) {
    std::signal(SIGSEGV, fault);
    volatile int* nowhere = nullptr;
    *nowhere = 1;
    return kSucceeded;
}

// Reports its start over descriptor 3, if it exists.
int sleepForever(std::span<char*>) {
    if (write(3, "x", 1) < 0) write(1, ".", 1);
    while (true)
        sleep(1000);
}

// Fills this many megabytes (MiB) and keeps them for ever.
int fill(std::span<char*> arguments) {
    const std::vector<char> kept(std::strtoul(arguments[0], nullptr, 10) << 20U, 'x');
    return sleepForever(arguments);
}

int newBomb(std::span<char*>) {
    std::vector<char*> kept;
    try {
        while (true) {
            kept.push_back(new char[16U << 20U]);
            std::memset(kept.back(), 1, 16U << 20U);
        }
    } catch (const std::bad_alloc&) {
        return kRefused;
    }
}

int mapBomb(std::span<char*>) {
    constexpr std::size_t kSize = 64U << 20U;
    while (true) {
        void* memory =
            mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) return kRefused;
        std::memset(memory, 1, kSize);
    }
}

// NOLINTNEXTLINE(misc-no-recursion): that is the trick.
int deeper(int depth) {
    volatile char room[4096] = {};
    room[0] = static_cast<char>(depth);
    return depth < 0 ? 0 : deeper(depth + 1) + room[0];
}

int stackOverflow(std::span<char*>) {
    return deeper(0);
}

int threadBomb(std::span<char*>) {
    std::vector<std::thread> workers;
    try {
        while (true)
            workers.emplace_back([] { pause(); });
    } catch (const std::exception&) {
        _exit(kRefused);
    }
}

int flood(std::span<char*> arguments) {
    const int descriptor = std::atoi(arguments[0]);
    const std::string text(4096, 'x');
    while (write(descriptor, text.data(), text.size()) > 0) {
    }
    return kRefused;
}

int forkBomb(std::span<char*>) {
    while (true)
        if (fork() < 0) pause();
}

int bigFile(std::span<char*>) {
    const std::string text(1U << 20U, 'x');
    for (int i = 0; i < 4096; ++i)
        if (write(3, text.data(), text.size()) < 0) return kRefused;
    return kSucceeded;
}

int raiseLimits(std::span<char*>) {
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    return setrlimit(RLIMIT_CPU, &more) == 0 ? kSucceeded : kRefused;
}

constexpr Trick kGreedyTricks[] = {{"loop", loop},
                                   {"busy-threads", busyThreads},
                                   {"ignore-cpu-limit", ignoreCpuLimit},
                                   {"ignore-cpu-limit-in-threads", ignoreCpuLimitInThreads},
                                   {"block-all-signals", blockAllSignals},
                                   {"segv-handler-loop", segvHandlerLoop},
                                   {"sleep", sleepForever},
                                   {"fill", fill},
                                   {"new-bomb", newBomb},
                                   {"map-bomb", mapBomb},
                                   {"stack-overflow", stackOverflow},
                                   {"thread-bomb", threadBomb},
                                   {"flood", flood},
                                   {"fork-bomb", forkBomb},
                                   {"big-file", bigFile},
                                   {"raise-limits", raiseLimits}};

}  // namespace

std::span<const Trick> greedy() {
    return kGreedyTricks;
}

}  // namespace tricks

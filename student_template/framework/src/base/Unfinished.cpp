#include <raytracer/base/Error.h>
#include <raytracer/base/Unfinished.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <string>

namespace raytracer {
namespace {

constexpr std::array<std::string_view, 3> kTasks{"T1", "T2.1", "T2.2"};

// Stubs call for every ray, so that there is neither a lock nor a search in a container.
constinit std::array<std::atomic<bool>, kTasks.size()> called{};

std::atomic<bool>& calledFor(std::string_view task) {
    for (std::size_t i = 0; i < kTasks.size(); ++i) {
        if (kTasks[i] == task) return called[i];
    }
    throw Error("there is no task " + std::string(task) + ", only T1, T2.1 and T2.2");
}

}  // namespace

void unfinished(std::string_view task, std::string_view hint) {
    std::atomic<bool>& known = calledFor(task);
    if (known.load(std::memory_order_relaxed) || known.exchange(true)) return;
    std::fprintf(stderr, "%.*s is not done yet: %.*s\n", static_cast<int>(task.size()), task.data(),
                 static_cast<int>(hint.size()), hint.data());
}

bool isUnfinished(std::string_view task) {
    return calledFor(task).load();
}

}  // namespace raytracer

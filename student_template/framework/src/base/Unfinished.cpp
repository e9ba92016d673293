#include <raytracer/base/Unfinished.h>

#include <cstdio>
#include <mutex>
#include <set>
#include <string>

namespace raytracer {
namespace {

struct Registry {
    std::mutex mutex;
    std::set<std::string, std::less<>> tasks;
};

Registry& registry() {
    static Registry instance;
    return instance;
}

}  // namespace

void unfinished(std::string_view task, std::string_view hint) {
    Registry& known = registry();
    const std::lock_guard lock{known.mutex};
    if (known.tasks.contains(task)) return;
    known.tasks.emplace(task);
    std::fprintf(stderr, "%.*s is not done yet: %.*s\n", static_cast<int>(task.size()), task.data(),
                 static_cast<int>(hint.size()), hint.data());
}

bool isUnfinished(std::string_view task) {
    Registry& known = registry();
    const std::lock_guard lock{known.mutex};
    return known.tasks.contains(task);
}

}  // namespace raytracer

#include <raytracer/base/Unfinished.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <string>

namespace raytracer {
namespace {

/// A task whose stub has been called, and the remark that it left.
struct Stub {
    std::string task;
    std::string remark;
    const Stub* next = nullptr;
};

/// The stubs that have been called. They are called for every ray: only the first call of each
/// takes the lock, the others read a list that grows at its head and never shrinks.
class CalledStubs {
public:
    [[nodiscard]] const Stub* find(std::string_view task) const {
        const Stub* stub = first_.load(std::memory_order_acquire);
        while (stub != nullptr && stub->task != task)
            stub = stub->next;
        return stub;
    }

    void add(std::string_view task, std::string_view hint) {
        const std::lock_guard lock{mutex_};
        if (find(task) != nullptr) return;
        const std::string name{task};
        stubs_.push_back({name, name + " is not done yet: " + std::string(hint), first_.load()});
        first_.store(&stubs_.back(), std::memory_order_release);
    }

private:
    std::atomic<const Stub*> first_{nullptr};
    std::mutex mutex_;
    std::deque<Stub> stubs_;  // a deque, so that the elements stay where they are
};

CalledStubs& calledStubs() {
    static CalledStubs stubs;
    return stubs;
}

}  // namespace

void unfinished(std::string_view task, std::string_view hint) {
    if (calledStubs().find(task) == nullptr) calledStubs().add(task, hint);
}

bool isUnfinished(std::string_view task) {
    return calledStubs().find(task) != nullptr;
}

std::string unfinishedRemark(std::string_view task) {
    const Stub* stub = calledStubs().find(task);
    return stub == nullptr ? "" : stub->remark;
}

}  // namespace raytracer

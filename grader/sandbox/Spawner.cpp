#include <grader/base/FileDescriptor.h>
#include <grader/sandbox/Spawner.h>

#include <fcntl.h>
#include <spawn.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace ticker::sandbox {
namespace {

// Sources are first copied to descriptors above every target, so that no redirection overwrites the
// source of another.
constexpr int kFirstParked = 128;

class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    int redirect(int host, int target) {
        return posix_spawn_file_actions_adddup2(&actions_, host, target);
    }
    int close(int target) { return posix_spawn_file_actions_addclose(&actions_, target); }
    int closeFrom(int first) { return posix_spawn_file_actions_addclosefrom_np(&actions_, first); }
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

class Attributes {
public:
    Attributes() {
        posix_spawnattr_init(&attributes_);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes_, &signals);
        // A session of its own: Ctrl-C on our terminal does not reach the job, and the job has no
        // controlling terminal to inject input into.
        posix_spawnattr_setflags(
            &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
    }
    ~Attributes() { posix_spawnattr_destroy(&attributes_); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

int describeDescriptors(const std::vector<Redirection>& redirections, FileActions& actions,
                        std::vector<FileDescriptor>& parked) {
    int last = -1;
    for (const Redirection& redirection : redirections) {
        parked.emplace_back(fcntl(redirection.host, F_DUPFD_CLOEXEC, kFirstParked));
        if (!parked.back().isOpen()) return errno;
        if (const int error = actions.redirect(parked.back().get(), redirection.target))
            return error;
        last = std::max(last, redirection.target);
    }
    for (int target = 0; target < last; ++target) {
        const bool used = std::any_of(redirections.begin(), redirections.end(),
                                      [=](const Redirection& r) { return r.target == target; });
        if (used) continue;
        if (const int error = actions.close(target)) return error;
    }
    return actions.closeFrom(last + 1);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> result;
    for (std::string& word : words)
        result.push_back(word.data());
    result.push_back(nullptr);
    return result;
}

Launched spawn(const Launch& launch) {
    FileActions actions;
    std::vector<FileDescriptor> parked;
    if (const int error = describeDescriptors(launch.redirections, actions, parked))
        return {-1, error};
    std::vector<std::string> words{launch.program.string()};
    words.insert(words.end(), launch.arguments.begin(), launch.arguments.end());
    const std::vector<char*> argv = pointers(words);
    char* const environment[] = {nullptr};
    const Attributes attributes;
    Launched launched;
    launched.error = posix_spawn(&launched.pid, launch.program.c_str(), actions.get(),
                                 attributes.get(), argv.data(), environment);
    if (launched.error != 0) launched.pid = -1;
    return launched;
}

class SpawnerThread {
public:
    SpawnerThread() : thread_([this] { serve(); }) { thread_.detach(); }

    Launched run(const Launch& launch) {
        std::packaged_task<Launched()> task{[&launch] { return spawn(launch); }};
        std::future<Launched> result = task.get_future();
        {
            const std::lock_guard lock{mutex_};
            tasks_.push_back(std::move(task));
        }
        wake_.notify_one();
        return result.get();
    }

private:
    void serve() {
        while (true) {
            std::unique_lock lock{mutex_};
            wake_.wait(lock, [this] { return !tasks_.empty(); });
            std::packaged_task<Launched()> task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::packaged_task<Launched()>> tasks_;
    std::thread thread_;
};

}  // namespace

Launched launch(const Launch& launch) {
    // Never destroyed: its thread runs until the process ends.
    static SpawnerThread& spawner = *new SpawnerThread;
    return spawner.run(launch);
}

}  // namespace ticker::sandbox

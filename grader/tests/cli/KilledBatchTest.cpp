#include "GradedClass.h"

#include <grader/store/Store.h>

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <random>
#include <set>
#include <stdexcept>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// Counts file system events in a folder and below it.
class Changes {
public:
    explicit Changes(const fs::path& folder) : descriptor_(inotify_init1(IN_CLOEXEC)) {
        if (descriptor_ < 0) throw std::runtime_error("no inotify");
        watch(folder);
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
            if (entry.is_directory()) watch(entry.path());
    }
    ~Changes() { close(descriptor_); }
    Changes(const Changes&) = delete;
    Changes& operator=(const Changes&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// Events since the last call.
    int take() {
        alignas(inotify_event) std::array<char, 16384> block{};
        const ssize_t size = read(descriptor_, block.data(), block.size());
        int count = 0;
        for (ssize_t at = 0; at < size; ++count) {
            const auto* event = reinterpret_cast<const inotify_event*>(block.data() + at);
            const auto known = folders_.find(event->wd);
            if ((event->mask & IN_ISDIR) != 0 && event->len > 0 && known != folders_.end())
                watch(known->second / event->name);
            at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
        }
        return count;
    }

private:
    void watch(const fs::path& folder) {
        const int watched = inotify_add_watch(descriptor_, folder.c_str(),
                                              IN_CREATE | IN_MODIFY | IN_MOVED_TO | IN_DELETE);
        if (watched >= 0) folders_[watched] = folder;
    }

    int descriptor_;
    std::map<int, fs::path> folders_;
};

class KilledBatch : public GradedClass {
protected:
    /// Runs ticker and kills it after this many events in OUT. @return  Whether it was still
    /// running.
    bool killAfter(const std::vector<std::string>& command, const fs::path& out, int changes) {
        fs::create_directory(out);
        Changes seen{out};
        RunningTicker ticker{command, at("errors").string()};
        for (int count = 0; count < changes;) {
            std::array<pollfd, 2> waiting{
                {{seen.descriptor(), POLLIN, 0}, {ticker.output(), POLLIN, 0}}};
            poll(waiting.data(), waiting.size(), -1);
            if ((waiting[0].revents & POLLIN) != 0)
                count += seen.take();
            else if (!ticker.readLine())
                return false;
        }
        ticker.send(SIGKILL);
        ticker.wait();
        return true;
    }

    /// Expects that an interrupted grading gives the same results as an uninterrupted one.
    void expectWhole() const {
        EXPECT_EQ(filesBelow(at("cut")), filesBelow(at("whole"))) << "nothing missing or left over";
        EXPECT_EQ(textOf(at("cut") / "summary.csv"), textOf(at("whole") / "summary.csv"));
        const auto rows = store::Store{at("cut")}.results();
        EXPECT_EQ(rows.size(), 6U);
        for (const store::ResultRow& row : rows) {
            EXPECT_EQ(row.timesGraded, 1) << row.submission;
            EXPECT_EQ(untimed(at("cut") / row.submission / "result.json"),
                      untimed(at("whole") / row.submission / "result.json"));
        }
    }

    /// Every file below a folder, except the store's own.
    static std::set<std::string> filesBelow(const fs::path& folder) {
        std::set<std::string> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
            if (!entry.path().filename().string().starts_with("results.sqlite"))
                files.insert(entry.path().lexically_relative(folder).string());
        return files;
    }
};

// More kills on request: TICKER_KILLS=20.
int numberOfKills() {
    const char* wanted = std::getenv("TICKER_KILLS");
    return wanted == nullptr ? 4 : std::atoi(wanted);
}

TEST_F(KilledBatch, GivesWhenResumedWhatAnUninterruptedRunGives) {
    fs::copy(fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples/awarded/reference-bump",
             at("class") / "right", fs::copy_options::recursive);
    run(gradeCommand("whole", {"--seed", "5"}));
    const auto command = gradeCommand("cut", {"--seed", "5", "--resume"});
    std::mt19937 generator{20261121};
    // A whole run has about 250 events; each run continues where the one before was killed.
    std::uniform_int_distribution<int> moment{1, 120};
    for (int kills = 0; kills < numberOfKills();) {
        if (killAfter(command, at("cut"), moment(generator))) {
            ++kills;
        } else {
            expectWhole();
            fs::remove_all(at("cut"));
        }
    }
    run(command);
    expectWhole();
}

}  // namespace
}  // namespace ticker::cli

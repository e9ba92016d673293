// Runs the public tests and prints for each task how many passed, and for each failure the
// question, the expected and the actual answer, and the likely mistake.
#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// One task and its test suite.
struct Task {
    std::string_view suite;
    std::string_view title;
    int passed = 0;
    int failed = 0;
    int notAttempted = 0;
    int notAsked = 0;  // could not be asked of this solution
    std::string whyNotAsked{};
};

std::string words(std::string_view name) {
    std::string text;
    for (const char c : name) {
        const bool capital = c >= 'A' && c <= 'Z';
        if (capital && !text.empty()) text += ' ';
        text += capital && !text.empty() ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return text;
}

/// The running test, readable by a signal handler: "T1   Normals have unit length".
std::array<char, 200> runningTest{};

/// Names the test that crashed, then ends the program as the signal would have.
extern "C" void tellOfCrash(int signal) {
    std::printf("NOT YET: %s\n  got:      your code crashed (signal %d)\n\n", runningTest.data(),
                signal);
    std::fflush(stdout);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

class FriendlyPrinter final : public testing::EmptyTestEventListener {
public:
    void OnTestStart(const testing::TestInfo& test) override {
        for (const Task& task : tasks_)
            if (task.suite == test.test_suite_name())
                std::snprintf(runningTest.data(), runningTest.size(), "%s %s",
                              std::string{task.title.substr(0, 4)}.c_str(),
                              words(test.name()).c_str());
    }

    // GoogleTest holds its lock here: asking it for the running test would deadlock.
    void OnTestPartResult(const testing::TestPartResult& part) override {
        if (part.skipped()) skippedBecause_ = part.message();
        if (!part.failed()) return;
        std::string_view message = part.message();
        const std::string_view prefix = "Failed\n";
        if (message.starts_with(prefix)) message.remove_prefix(prefix.size());
        std::printf("NOT YET: %s\n%s\n\n", runningTest.data(), std::string{message}.c_str());
        std::fflush(stdout);
    }

    void OnTestEnd(const testing::TestInfo& test) override {
        for (Task& task : tasks_) {
            if (task.suite != test.test_suite_name()) continue;
            if (!test.result()->Skipped()) {
                ++(test.result()->Passed() ? task.passed : task.failed);
            } else if (skippedBecause_.find("not attempted") != std::string::npos) {
                ++task.notAttempted;
            } else {
                ++task.notAsked;
                task.whyNotAsked = skippedBecause_;
            }
        }
    }

    void OnTestProgramEnd(const testing::UnitTest& /*all*/) override {
        for (const Task& task : tasks_)
            print(task);
    }

private:
    static void print(const Task& task) {
        const int asked = task.passed + task.failed;
        const std::string title{task.title};
        if (asked + task.notAttempted + task.notAsked == 0) return;
        if (asked == 0 && task.notAttempted > 0) {
            std::printf("%s not attempted\n", title.c_str());
            return;
        }
        if (asked == 0) {
            std::printf("%s %s\n", title.c_str(), task.whyNotAsked.c_str());
            return;
        }
        std::printf("%s %d of %d public tests passed", title.c_str(), task.passed, asked);
        if (task.notAsked > 0) std::printf(", %d could not be asked", task.notAsked);
        std::printf("\n");
    }

    // From check.json.
    std::vector<Task> tasks_{
#include "Tasks.inc"
    };
    std::string skippedBecause_;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // GoogleTest's --gtest_list_tests and its XML and JSON reports work as usual; --verbose keeps
    // GoogleTest's own printer.
    const bool verbose = argc > 1 && std::string_view{argv[1]} == "--verbose";
    if (!verbose) {
        testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FriendlyPrinter);  // the list owns it
        for (const int signal : {SIGSEGV, SIGFPE, SIGILL, SIGABRT})
            std::signal(signal, tellOfCrash);
    }
    return RUN_ALL_TESTS();
}

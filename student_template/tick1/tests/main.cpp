// Asks the public tests' questions and says what a student wants to know.
// public_tests [TASK]: only this task.
#include "PublicTests.h"

#include <raytracer/base/Unfinished.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

int main(int argc, char** argv) {
    using namespace raytracer;
    bool good = true;
    for (const tests::Suite& suite : tests::suites()) {
        if (argc > 1 && std::string_view{argv[1]} != suite.task) continue;
        std::fflush(stdout);
        std::size_t right = 0;
        const auto outcomes = suite.ask();
        if (isUnfinished(suite.task)) {
            std::printf("%-4s %s: not attempted\n", suite.task, suite.title);
            continue;
        }
        const auto missing = std::find_if(suite.needs.begin(), suite.needs.end(),
                                          [](const char* task) { return isUnfinished(task); });
        if (missing != suite.needs.end()) {
            std::printf("%-4s %s: cannot be asked before %s is done\n", suite.task, suite.title,
                        *missing);
            continue;
        }
        for (const tests::Outcome& outcome : outcomes) {
            if (outcome.isRight)
                ++right;
            else
                std::printf(
                    "\nNOT YET: %s\n  asked:    %s\n  expected: %s\n  got:      %s\n"
                    "  likely:   %s\n",
                    suite.task, outcome.asked.c_str(), outcome.expected.c_str(),
                    outcome.got.c_str(), outcome.likely.c_str());
        }
        std::printf("%-4s %s: %zu of %zu public tests passed\n", suite.task, suite.title, right,
                    outcomes.size());
        good = good && right == outcomes.size();
    }
    return good ? 0 : 1;
}

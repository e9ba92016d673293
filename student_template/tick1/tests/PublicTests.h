#ifndef PUBLICTESTS_H
#define PUBLICTESTS_H

#include <string>
#include <vector>

namespace raytracer::tests {

/// One question, and what came of it.
struct Outcome {
    std::string asked;
    std::string expected;
    std::string got;
    std::string likely;  ///< what to look at where it is wrong
    bool isRight = false;
};

/// One task: its tag, its title and its questions.
struct Suite {
    const char* task;
    const char* title;
    std::vector<Outcome> (*ask)();
    std::vector<const char*> needs;  ///< tasks without which it cannot be asked
};

[[nodiscard]] std::vector<Suite> suites();

}  // namespace raytracer::tests

#endif

#ifndef TICKER_SANDBOX_DIAGNOSIS_H
#define TICKER_SANDBOX_DIAGNOSIS_H

#include <grader/sandbox/Sandbox.h>

#include <string>
#include <vector>

namespace ticker::sandbox {

/// What this machine says to one level.
struct Diagnosis {
    Level level = Level::none;
    bool available = false;
    std::string reason;  ///< what makes it available, or what is in the way; one sentence
    std::string advice;  ///< what to do about that; empty where there is nothing to do
};

/// Tries `level` by running a program that does nothing; about 10 ms, once in a process.
[[nodiscard]] const Diagnosis& diagnose(Level level);

/// All levels, the best first.
[[nodiscard]] std::vector<Diagnosis> diagnose();

}  // namespace ticker::sandbox

#endif

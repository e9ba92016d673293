#ifndef TICKER_SANDBOX_LEVELDIAGNOSIS_H
#define TICKER_SANDBOX_LEVELDIAGNOSIS_H

#include <grader/sandbox/Sandbox.h>

#include <string>
#include <vector>

namespace ticker::sandbox {

/// Whether this machine offers one level.
struct Diagnosis {
    Level level = Level::none;
    bool available = false;
    std::string reason;  ///< what makes it available, or what prevents it; one sentence
    std::string advice;  ///< how to remove the obstacle; empty if nothing can be done
};

/// Tries `level` by running a program that does nothing: about 10 ms, once in a process.
[[nodiscard]] const Diagnosis& diagnose(Level level);

/// All levels, the best first.
[[nodiscard]] std::vector<Diagnosis> diagnose();

/// What is said where no level confines commands: the reason of each that is missing, and where to
/// read on.
[[nodiscard]] std::string refusalOf(const std::vector<Diagnosis>& levels);

}  // namespace ticker::sandbox

#endif

#ifndef TICKER_REPAIR_SEARCHLIMITS_H
#define TICKER_REPAIR_SEARCHLIMITS_H

#include <grader/sandbox/SandboxPolicy.h>

#include <string>

namespace ticker::repair {

/// How long edits of one submission are looked for. Contents of limits.json.
struct SearchLimits {
    /// All of it: parsing, compiling, asking, judging, proving; of all failed tasks together.
    sandbox::TimeLimits all;
    /// The share of a task's CPU time after which a task with a proven repair gets no other, 0
    /// to 1.
    double others = 0.0;
    // The share of a task's CPU time after which the next kind of edits has its turn, 0 to 1.
    double singles = 0.0;      ///< one edit
    double formulas = 0.0;     ///< an expression of the handout in place of a value
    double wide = 0.0;         ///< one edit that puts in what stands nowhere near
    double twins = 0.0;        ///< the same edit at several places
    double pairs = 0.0;        ///< two edits of one statement
    double twoMistakes = 0.0;  ///< edits of two mistakes
};

/// The limits.json that is compiled into this program.
[[nodiscard]] const SearchLimits& defaultSearchLimits();

/// @param text  JSON as in grader/repair/limits.json: every field is required, no other is allowed;
///              shares grow from kind to kind.
/// @param name  Name of the text in error messages.
/// @throws raytracer::InputError with the field, its value and what was expected.
[[nodiscard]] SearchLimits parseSearchLimits(const std::string& text, const std::string& name);

}  // namespace ticker::repair

#endif

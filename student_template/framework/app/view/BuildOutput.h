#ifndef RAYTRACER_APP_VIEW_BUILDOUTPUT_H
#define RAYTRACER_APP_VIEW_BUILDOUTPUT_H

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace raytracer::view {

/// The first thing that a compiler or linker refuses.
struct FirstError {
    std::string file;  ///< as the compiler writes it; empty where the linker complains
    int line = 0;
    std::string message;
};

/// Reads what GCC, Clang or Microsoft's compiler wrote. Empty where nothing in it is an error.
[[nodiscard]] std::optional<FirstError> firstErrorIn(std::string_view output);

/// What the public tests say, for a person who works on some of the tasks.
struct TestOutcome {
    bool hasFailed = false;
    std::string title;    ///< of the first test that fails: "T1   Normals have unit length"
    std::string text;     ///< what it asked, expected and got
    std::string summary;  ///< a line for each of the tasks
};

/// @param tasks  Tags of the tasks; empty: all.
[[nodiscard]] TestOutcome testOutcomeIn(std::string_view output,
                                        const std::set<std::string>& tasks);

/// The tags that a file of the exercise has marks of: "// TASK T1 begin".
[[nodiscard]] std::set<std::string> tasksIn(std::string_view source);

}  // namespace raytracer::view

#endif

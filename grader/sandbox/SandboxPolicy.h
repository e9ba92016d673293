#ifndef TICKER_SANDBOX_SANDBOXPOLICY_H
#define TICKER_SANDBOX_SANDBOXPOLICY_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/UserSlots.h>

#include <filesystem>
#include <string>

namespace ticker::sandbox {

/// Time limits of all runs of one submission together.
struct TimeLimits {
    double cpuSeconds = 0.0;
    double wallSeconds = 0.0;
};

/// Contents of limits.json: limits for each kind of job, and the uids reserved for jails.
struct SandboxPolicy {
    UserRange users;
    Limits compile;         ///< compiling and linking a student's file
    Limits run;             ///< one run of a submission that answers questions
    TimeLimits submission;  ///< all such runs of a submission together
    Limits decode;          ///< decoding a student's picture with our decoder
    Limits match;           ///< comparing the files of a whole class with each other
};

/// The limits.json that is compiled into this program.
[[nodiscard]] const SandboxPolicy& defaultPolicy();

/// @param text  JSON as in grader/sandbox/limits.json: every field is required, no other is
///         allowed.
/// @param name  Name of the text in error messages.
/// @throws raytracer::InputError with the field, its value and what was expected.
[[nodiscard]] SandboxPolicy parsePolicy(const std::string& text, const std::string& name);

/// parsePolicy of a file. @throws raytracer::InputError also if it cannot be read.
[[nodiscard]] SandboxPolicy readPolicy(const std::filesystem::path& file);

}  // namespace ticker::sandbox

#endif

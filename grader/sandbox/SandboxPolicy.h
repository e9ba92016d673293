#ifndef TICKER_SANDBOX_SANDBOXPOLICY_H
#define TICKER_SANDBOX_SANDBOXPOLICY_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/UserSlots.h>

#include <filesystem>
#include <string>

namespace ticker::sandbox {

/// What all runs of one submission may take together.
struct TimeLimits {
    double cpuSeconds = 0.0;
    double wallSeconds = 0.0;
};

/// What limits.json holds: how much each kind of job may use, and which uids belong to jails.
struct SandboxPolicy {
    UserRange users;
    Limits compile;         ///< a student's file, by the compiler; the link
    Limits run;             ///< a submission that answers questions, each time that it is run
    TimeLimits submission;  ///< a submission that answers questions, all runs of it together
    Limits decode;          ///< a student's picture, by our decoder
};

/// The limits.json that this program was built with.
[[nodiscard]] const SandboxPolicy& defaultPolicy();

/// @param text  JSON as in grader/sandbox/limits.json: every field is required, none other allowed.
/// @param name  What an error calls the text.
/// @throws raytracer::InputError naming the field, what was found and what was expected.
[[nodiscard]] SandboxPolicy parsePolicy(const std::string& text, const std::string& name);

/// parsePolicy of a file. @throws raytracer::InputError also where it cannot be read.
[[nodiscard]] SandboxPolicy readPolicy(const std::filesystem::path& file);

}  // namespace ticker::sandbox

#endif

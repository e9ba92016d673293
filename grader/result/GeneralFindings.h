#ifndef TICKER_RESULT_GENERALFINDINGS_H
#define TICKER_RESULT_GENERALFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker {

// Findings that can apply to any task.

inline constexpr FindingText kBuildFailed{.id = "build.failed",
                                          .words = "did not compile",
                                          .meaning = "the compiler or the linker refused a file"};

inline constexpr FindingText kBuildLimit{
    .id = "build.limit",
    .words = "took the compiler beyond its limits",
    .meaning = "the compiler needed more time or memory than it may have"};

inline constexpr FindingText kBuildForbidden{
    .id = "build.forbidden",
    .words = "defined what belongs to the framework",
    .meaning = "a file defines what belongs to the framework"};

inline constexpr FindingText kRunCrashed{
    .id = "run.crashed",
    .words = "crashed",
    .meaning = "the program crashed, or an exception came out of it"};

inline constexpr FindingText kRunTimedOut{
    .id = "run.timed-out",
    .words = "ran out of time",
    .meaning = "the program was still busy when its time was up"};

inline constexpr FindingText kRunMemory{
    .id = "run.memory",
    .words = "ran out of memory",
    .meaning = "the program asked for more memory than it may have"};

inline constexpr FindingText kRunOutputLimit{.id = "run.output-limit",
                                             .words = "wrote more than it may",
                                             .meaning = "the program printed more than it may"};

inline constexpr FindingText kRunForbiddenCall{
    .id = "run.forbidden-call",
    .words = "made a forbidden call",
    .meaning = "the program asked the system for what a renderer does not need"};

inline constexpr FindingText kRunNoAnswer{
    .id = "run.no-answer", .words = "gave no answer", .meaning = "a question got no answer"};

inline constexpr FindingText kRunExitedEarly{.id = "run.exited-early",
                                             .words = "ended too early",
                                             .meaning = "the program ended before it had answered"};

inline constexpr FindingText kSettingsHardCoded{
    .id = "settings.hard-coded",
    .words = "ignored the settings",
    .meaning = "warn: right with the handout's numbers, but it does not follow settings()",
    .hint =
        "Take the numbers from settings(): shadowRayCount, lightSize, dofRayCount, dofFocalPlane, "
        "dofAmount, bounces."};

inline constexpr FindingText kIntakeMissingFile{
    .id = "intake.missing-file", .words = "left a file out", .meaning = "a file is not there"};

inline constexpr FindingText kIntakeAmbiguous{.id = "intake.ambiguous",
                                              .words = "handed in two versions of a file",
                                              .meaning = "a file is there in two versions"};

inline constexpr FindingText kIntakeUnsafeArchive{
    .id = "intake.unsafe-archive",
    .words = "sent an archive that is not safe",
    .meaning = "no zip or tar archive, a damaged one, or one with unsafe names"};

inline constexpr FindingText kIntakeNotText{.id = "intake.not-text",
                                            .words = "sent a source file that is no text",
                                            .meaning = "a source file is no text"};

inline constexpr FindingText kIntakeTooLarge{
    .id = "intake.too-large",
    .words = "sent a file that is too large",
    .meaning = "a file, or all files together, are too large"};

/// The findings that belong to no task.
inline constexpr std::array kGeneralFindings{
    &kBuildFailed,     &kBuildLimit,          &kBuildForbidden,    &kRunCrashed,
    &kRunTimedOut,     &kRunMemory,           &kRunOutputLimit,    &kRunForbiddenCall,
    &kRunNoAnswer,     &kRunExitedEarly,      &kSettingsHardCoded, &kIntakeMissingFile,
    &kIntakeAmbiguous, &kIntakeUnsafeArchive, &kIntakeNotText,     &kIntakeTooLarge};

/// Whether an id says how the program ended, and nothing about its answers.
[[nodiscard]] inline bool isRunEnd(std::string_view id) {
    return id.starts_with("run.");
}

}  // namespace ticker

#endif

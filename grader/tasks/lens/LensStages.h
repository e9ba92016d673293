#ifndef TICKER_TASKS_LENS_LENSSTAGES_H
#define TICKER_TASKS_LENS_LENSSTAGES_H

#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/support/Stage.h>

#include <optional>

namespace ticker::tasks {

/// Asks a question once more, with one thread and in a fresh program, before threads, memory or
/// settings are blamed for its wrong answer.
/// @return  The failure of that answer; empty if the answer is right, so that threads, memory or
///          settings are the cause. Also empty if no picture of the right size came.
[[nodiscard]] std::optional<Finding> failureAlone(probe::Examinee& examinee,
                                                  probe::RenderQuestion asked, bool mayAntialias);

// Each stage asks questions of its own, drawn from `seed` and the stage's number.

/// Result of pictures.
struct PictureStage {
    Stage stage;
    bool antialiased = false;  ///< they are pictures of rays through all places of a pixel
};
/// Judges the pictures of `render`, for code whose rays are not visible.
/// @param shelf  Keeps expected pictures; submissions that get the same questions may share it.
[[nodiscard]] PictureStage judgePicture(probe::Examinee& examinee, ExpectationShelf& shelf,
                                        std::uint64_t seed, std::uint64_t stage);

/// Judges `render` with two threads, for code that is right with one. A data race may show or not:
/// the question is put again, up to seven times, until the threads have interrupted each other
/// often enough.
/// @param mayAntialias  See `LensLog`.
[[nodiscard]] Stage judgeThreads(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                                 std::uint64_t stage);

/// Judges `render` after another picture of the same size, for code that is right in the first.
[[nodiscard]] Stage judgeNext(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                              std::uint64_t stage);

}  // namespace ticker::tasks

#endif

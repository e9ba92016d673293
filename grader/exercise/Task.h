#ifndef TICKER_EXERCISE_TASK_H
#define TICKER_EXERCISE_TASK_H

#include <grader/exercise/Judge.h>
#include <grader/exercise/Screening.h>
#include <grader/probe/Examinee.h>
#include <grader/result/FindingText.h>
#include <grader/result/SubmissionResult.h>

#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ticker {

/// Distance of a picture of the handout's scene from the expectation for an accepted aperture.
struct Misfit {
    double apertureFactor = 1.0;  ///< half-width / dofAmount: 1 or 0.5
    /// Mean square of the pixels' differences in standard errors. It is below 1 for right pictures,
    /// because pixels without noise are included.
    double meanSquare = 0.0;
};

/// What the submission's renders of its file's scenes show.
struct RenderEvidence {
    /// Misfit of the random scene for each aperture that was tried; empty if no picture came.
    std::vector<Misfit> misfits;
    /// The largest `tasks::bumpMisfit`; empty if no scene has a relief, or if a picture is missing.
    std::optional<double> bumpMisfit;
};

/// The code of a task; its data is in the exercise's file. One row of `tasks::tasksOf`.
struct Task {
    std::string_view id;
    /// Its findings, in the order in which they are reported: reports, rubrics and
    /// docs/findings.md have their words from here.
    std::span<const FindingText* const> findings;
    /// Asks the submission and judges its answers. The tasks of a file may be judged in parallel,
    /// each in processes of its own.
    /// @param seed  Source of every hidden question; equal seeds give equal findings for code that
    ///              uses the kit's generator.
    TaskJudgement (*judge)(probe::Examinee& examinee, std::uint64_t seed) = nullptr;
    /// Whether a scene shows this task's work; null if none does. The file of the first task for
    /// which this is true renders the scene.
    bool (*isSeenIn)(const raytracer::SceneDescription& scene) = nullptr;
    /// Asks for review if the renders do not agree with the submission's answers; may be null.
    /// @param tasks  All tasks of the task's file.
    void (*doubt)(std::vector<TaskReport>& tasks, const RenderEvidence& renders) = nullptr;
    /// Cheap questions, for judging hundreds of edits of one submission; may be null.
    Screening (*screen)(std::uint64_t seed) = nullptr;
    /// Further screenings for a submission that passes `screen`, which show what `screen` may miss;
    /// may be null.
    std::vector<Screening> (*screenElsewhere)(std::uint64_t seed) = nullptr;
    /// A judge of many submissions under the same seeds, which keeps what it computes from a seed
    /// alone; null if there is nothing to keep.
    Judge (*judgeOfMany)() = nullptr;
    /// Adds drawings for people to a judgement, from questions of its own, and changes nothing
    /// else; may be null.
    void (*draw)(probe::Examinee& examinee, TaskJudgement& judgement) = nullptr;
};

/// The task's judge of many submissions under the same seeds: `judge` itself where nothing is kept.
[[nodiscard]] inline Judge judgeOfMany(const Task& task) {
    return task.judgeOfMany != nullptr ? task.judgeOfMany() : Judge{task.judge};
}

}  // namespace ticker

#endif

#ifndef TICKER_EXERCISE_TASK_H
#define TICKER_EXERCISE_TASK_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ticker {

/// How far a picture of the handout's scene is from what an accepted aperture gives.
struct Misfit {
    double apertureFactor = 1.0;  ///< half-width / dofAmount: 1 or 0.5
    /// Mean square of a pixel's difference in standard errors: below 1, since pixels without noise
    /// count, too.
    double meanSquare = 0.0;
};

/// What the submission's renders of its file's scenes show.
struct RenderEvidence {
    /// Of the random scene beside each aperture that was tried; none: no picture came.
    std::vector<Misfit> misfits;
    /// The largest of `tasks::bumpMisfit`; empty: no scene has a relief, or a picture did not come.
    std::optional<double> bumpMisfit;
};

/// The code of a task; its data stands in the exercise's file. A row of `tasks::theTasks`.
struct Task {
    std::string_view id;
    /// Asks the submission and judges its answers. The tasks of a file may be judged in parallel,
    /// each in processes of its own.
    /// @param seed  Every hidden question is drawn from it; equal seeds give equal findings for
    ///              code that uses the kit's generator.
    TaskJudgement (*judge)(probe::Examinee& examinee, std::uint64_t seed) = nullptr;
    /// Whether a scene shows this task's work. The first task that says so is the one whose file
    /// renders the scene.
    bool (*isSeenIn)(const raytracer::SceneDescription& scene) = nullptr;
    /// Leaves a submission to a person where its renders do not show what it answers; may be null.
    /// @param tasks  All of the task's file.
    void (*doubt)(std::vector<TaskReport>& tasks, const RenderEvidence& renders) = nullptr;
};

}  // namespace ticker

#endif

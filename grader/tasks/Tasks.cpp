#include <grader/tasks/Tasks.h>

#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/BumpPicture.h>
#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tasks/bump/ScreenBump.h>
#include <grader/tasks/drawings/DrawBumps.h>
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/ScreenLens.h>
#include <grader/tasks/lens/checks/PictureDoubt.h>
#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tasks/shadows/ScreenShadows.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ticker::tasks {
namespace {

bool isAnyScene(const raytracer::SceneDescription& /*scene*/) {
    return true;
}

void doubtT1(std::vector<TaskReport>& tasks, const RenderEvidence& renders) {
    doubtBumps(tasks.at(0), renders.bumpMisfit);
}

void doubtT22(std::vector<TaskReport>& tasks, const RenderEvidence& renders) {
    std::optional<double> aperture;
    for (const TaskReport& task : tasks)
        if (task.apertureFactor) aperture = task.apertureFactor;
    doubtPicture(tasks, renders.misfits, aperture);
}

constexpr std::array kTick1star{Task{.id = "T1",
                                     .findings = kBumpFindings,
                                     .judge = judgeBump,
                                     .isSeenIn = hasRelief,
                                     .doubt = doubtT1,
                                     .screen = screenBump,
                                     .screenElsewhere = screenBumpElsewhere,
                                     .draw = drawBumps},
                                Task{.id = "T2.1",
                                     .findings = kShadowFindings,
                                     .judge = judgeShadows,
                                     .isSeenIn = isAnyScene,
                                     .screen = screenShadows,
                                     .judgeOfMany = judgeShadowsOfMany},
                                Task{.id = "T2.2",
                                     .findings = kLensFindings,
                                     .judge = judgeLens,
                                     .isSeenIn = isAnyScene,
                                     .doubt = doubtT22,
                                     .screen = screenLens,
                                     .judgeOfMany = judgeLensOfMany}};

constexpr std::array kTick1{
    Task{.id = "M1", .findings = kSphereFindings, .judge = judgeSpheres, .isSeenIn = isAnyScene},
    Task{.id = "M2",
         .findings = kPhongFindings,
         .judge = judgePhong,
         .isSeenIn = isAnyScene,
         .judgeOfMany = judgePhongOfMany},
    Task{.id = "M3.1", .findings = kPlaneFindings, .judge = judgePlanes, .isSeenIn = isAnyScene},
    Task{.id = "M3.2",
         .findings = kShadeFindings,
         .judge = judgeHardShadows,
         .isSeenIn = isAnyScene,
         .judgeOfMany = judgeHardShadowsOfMany},
    Task{.id = "M4",
         .findings = kMirrorFindings,
         .judge = judgeReflections,
         .isSeenIn = isAnyScene,
         .judgeOfMany = judgeReflectionsOfMany}};

struct Rows {
    std::string_view exercise;
    std::span<const Task> tasks;
};

constexpr std::array kExercises{Rows{"tick1star", kTick1star}, Rows{"tick1", kTick1}};

}  // namespace

std::span<const Task> tasksOf(std::string_view exercise) {
    const auto* const found = std::ranges::find(kExercises, exercise, &Rows::exercise);
    return found == kExercises.end() ? std::span<const Task>{} : found->tasks;
}

std::vector<TaskReport> judgeFile(const Exercise& exercise, std::string_view file,
                                  probe::Examinee& examinee, std::uint64_t seed,
                                  std::string_view only) {
    std::vector<TaskReport> reports;
    for (const Task& task : tasksOf(exercise.name)) {
        if (exercise.fileOf(task.id) != file || (!only.empty() && task.id != only)) continue;
        TaskReport& report = reports.emplace_back();
        static_cast<TaskJudgement&>(report) = task.judge(examinee, seed);
        report.id = task.id;
        report.title = exercise.task(task.id)->title;
    }
    return reports;
}

}  // namespace ticker::tasks

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

constexpr std::array kTick1star{
    Task{"T1", kBumpFindings, judgeBump, hasRelief, doubtT1, screenBump, nullptr, drawBumps},
    Task{"T2.1", kShadowFindings, judgeShadows, isAnyScene, nullptr, screenShadows,
         judgeShadowsOfMany},
    Task{"T2.2", kLensFindings, judgeLens, isAnyScene, doubtT22, screenLens, judgeLensOfMany}};

constexpr std::array kTick1{Task{"M1", kSphereFindings, judgeSpheres, isAnyScene},
                            Task{"M2", kPhongFindings, judgePhong, isAnyScene},
                            Task{"M3.1", kPlaneFindings, judgePlanes, isAnyScene},
                            Task{"M3.2", kShadeFindings, judgeHardShadows, isAnyScene},
                            Task{"M4", kMirrorFindings, judgeReflections, isAnyScene}};

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

#include <grader/pipeline/RenderSubmission.h>

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/pipeline/SpecScenes.h>

#include <raytracer/base/Error.h>

#include <string>

namespace ticker::pipeline {
namespace {

std::string fileFor(const raytracer::SceneDescription& scene, const Grader& grader) {
    for (const Task& task : grader.tasks)
        if (task.isSeenIn != nullptr && task.isSeenIn(scene))
            return std::string{grader.exercise->fileOf(task.id)};
    throw raytracer::Error("no task has to do with this scene");
}

}  // namespace

raytracer::ByteImage renderSubmission(const intake::Submission& submission, const Grader& grader,
                                      const raytracer::SceneDescription& scene,
                                      const raytracer::RenderSettings& settings) {
    const std::string file = fileFor(scene, grader);
    const auto& source = submission.part(file);
    if (!source)
        throw raytracer::InputError(submission.name, 0,
                                    "has no " + file + ", which this scene needs");
    const build::BuildResult built =
        build::buildProgram(grader.kit, grader.sandbox, grader.policy.compile, file, *source);
    if (!built.program)
        throw raytracer::InputError(file, 0, "does not compile; ticker check shows why");
    sandbox::Limits limits = grader.policy.run;
    constexpr double kPatience =
        60.0;  // a full picture has many times the pixels of the grader's small ones
    limits.cpuSeconds *= kPatience;
    limits.wallSeconds *= kPatience;
    build::SandboxedExaminee examinee{*built.program, grader.sandbox, limits};
    const probe::Run run = examinee.ask({probe::RenderQuestion{scene, settings, 1, 0}});
    const auto picture = pictureFrom(std::get<probe::RenderAnswer>(run.answers.at(0)));
    if (!picture) throw raytracer::InputError(file, 0, "gave no picture: " + run.end.detail);
    return *picture;
}

}  // namespace ticker::pipeline

#include <grader/pipeline/RenderSubmission.h>

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/pipeline/SpecScenes.h>

#include <raytracer/base/Error.h>

#include <string>
#include <utility>

namespace ticker::pipeline {
namespace {

std::string fileFor(const raytracer::SceneDescription& scene, const Grader& grader) {
    for (const Task& task : grader.tasks)
        if (task.isSeenIn != nullptr && task.isSeenIn(scene))
            return std::string{grader.exercise->fileOf(task.id)};
    throw raytracer::Error("no task has to do with this scene");
}

/// @throws raytracer::InputError where the file is to blame, raytracer::Error where we are.
build::Program programOf(build::BuildResult built, const std::string& file) {
    using Kind = build::BuildResult::Kind;
    if (built.program) return std::move(*built.program);
    switch (built.kind) {
        case Kind::limit:
            throw raytracer::InputError(file, 0,
                                        "takes the compiler more time, memory or output than it "
                                        "may use; ticker check shows where");
        case Kind::forbidden:
            throw raytracer::InputError(file, 0,
                                        "defines something that belongs to the framework, such as "
                                        "main; ticker check shows what");
        case Kind::failed:
            throw raytracer::InputError(file, 0, "does not compile; ticker check shows why");
        default:
            throw raytracer::Error("the compiler could not be run: " + built.diagnostics);
    }
}

raytracer::ByteImage pictureOf(const probe::Run& run, const std::string& file) {
    if (auto picture = pictureFrom(std::get<probe::RenderAnswer>(run.answers.at(0))))
        return std::move(*picture);
    if (run.end.kind == probe::ProcessEnd::Kind::ourFault)
        throw raytracer::Error(file + " could not be run: " + run.end.detail);
    throw raytracer::InputError(file, 0, "gave no picture: " + run.end.detail);
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
    const build::Program program = programOf(
        build::buildProgram(grader.kit, grader.sandbox, grader.policy.compile, file, *source),
        file);
    sandbox::Limits limits = grader.policy.run;
    constexpr double kPatience =
        60.0;  // a full picture has many times the pixels of the grader's small ones
    limits.cpuSeconds *= kPatience;
    limits.wallSeconds *= kPatience;
    build::SandboxedExaminee examinee{program, grader.sandbox, limits};
    return pictureOf(examinee.ask({probe::RenderQuestion{scene, settings, 1, 0}}), file);
}

}  // namespace ticker::pipeline

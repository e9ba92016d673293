#include <grader/pipeline/RenderSubmission.h>

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/pipeline/SpecScenes.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <string>

namespace ticker::pipeline {
namespace {

build::SourceFile fileFor(const raytracer::SceneDescription& scene) {
    const bool bumpy = std::ranges::any_of(
        scene.spheres, [](const auto& sphere) { return sphere.heightMap != nullptr; });
    return bumpy ? build::SourceFile::bumpySphere : build::SourceFile::renderer;
}

}  // namespace

raytracer::ByteImage renderSubmission(const intake::Submission& submission, const Grader& grader,
                                      const raytracer::SceneDescription& scene,
                                      const raytracer::RenderSettings& settings) {
    const build::SourceFile file = fileFor(scene);
    const auto& source =
        submission.part(file == build::SourceFile::bumpySphere ? intake::Part::bumpySphere
                                                               : intake::Part::renderer);
    if (!source)
        throw raytracer::InputError(submission.name, 0,
                                    "has no " + build::nameOf(file) + ", which this scene needs");
    const build::BuildResult built =
        build::buildProgram(grader.kit, grader.sandbox, grader.policy.compile, file, *source);
    if (!built.program)
        throw raytracer::InputError(build::nameOf(file), 0,
                                    "does not compile; ticker check shows why");
    sandbox::Limits limits = grader.policy.run;
    constexpr double kPatience = 60.0;  // a full picture is many times the grader's small ones
    limits.cpuSeconds *= kPatience;
    limits.wallSeconds *= kPatience;
    build::SandboxedExaminee examinee{*built.program, grader.sandbox, limits};
    const probe::Sitting sitting = examinee.ask({probe::RenderQuestion{scene, settings, 1, 0}});
    const auto picture = pictureFrom(std::get<probe::RenderAnswer>(sitting.answers.at(0)));
    if (!picture)
        throw raytracer::InputError(build::nameOf(file), 0,
                                    "gave no picture: " + sitting.end.detail);
    return *picture;
}

}  // namespace ticker::pipeline

#include <grader/lab/selftest/ScreenshotStudent.h>

#include <grader/base/CpuTime.h>
#include <grader/tasks/screenshot/JudgeScreenshot.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace ticker::selftest {
namespace {

using metrics::Picture;
using pipeline::SpecScene;
using tasks::screenshot::Scene;

raytracer::ByteImage asked(probe::Examinee& code, const SpecScene& scene,
                           const raytracer::RenderSettings& settings) {
    const probe::Run run = code.ask({probe::RenderQuestion{scene.scene, settings, 1, 0}});
    std::optional<raytracer::ByteImage> image =
        pipeline::pictureFrom(std::get<probe::RenderAnswer>(run.answers.at(0)));
    if (!image)
        throw raytracer::Error("a student of the selftest gave no picture: " + run.end.detail);
    return *std::move(image);
}

}  // namespace

ScreenshotStudent::ScreenshotStudent(const std::vector<SpecScene>& scenes, bool isDeterministic,
                                     probe::Examinee& code)
    : scenes_(scenes), isDeterministic_(isDeterministic), code_(code) {
    for (const SpecScene& scene : scenes) {
        if (scene.isRandom == isDeterministic) continue;
        if (scene.isHandedIn) scene_ = &scene;
        own_.push_back({scene.name, asked(code, scene, scene.settings)});
    }
}

Picture ScreenshotStudent::render(int width, std::uint64_t seed, int rays) const {
    return render(*scene_, width, width * 3 / 4, seed, rays);
}

Picture ScreenshotStudent::render(const SpecScene& scene, int width, int height, std::uint64_t seed,
                                  int rays) const {
    raytracer::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.seed = seed;
    settings.dofRayCount = rays;
    raytracer::ByteImage image = asked(code_, scene, settings);
    return {image.width, image.height, std::move(image.rgb)};
}

TaskJudgement ScreenshotStudent::handIn(const Picture& picture, std::uint64_t seed,
                                        double& judgeMs) const {
    std::vector<Scene> scenes;
    for (const SpecScene& spec : scenes_) {
        Scene scene;
        scene.name = spec.name;
        scene.file = spec.file;
        scene.isRandom = spec.isRandom;
        scene.isWanted = spec.isHandedIn && spec.isRandom != isDeterministic_;
        scene.description = &spec.scene;
        scene.expected = [&spec] { return metrics::viewOf(spec.expected().picture); };
        if (spec.isRandom != isDeterministic_) scene.examinee = &code_;
        const auto own = std::ranges::find(own_, spec.name, &pipeline::Rendered::scene);
        if (own != own_.end()) scene.own = metrics::viewOf(own->picture);
        scenes.push_back(scene);
    }
    const double before = threadCpuMs();
    TaskJudgement judgement = tasks::judgeScreenshot(picture.view(), scenes, seed);
    judgeMs = threadCpuMs() - before;
    return judgement;
}

}  // namespace ticker::selftest

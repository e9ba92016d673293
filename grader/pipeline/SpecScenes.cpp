#include <grader/pipeline/SpecScenes.h>

#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/picture/EncodePicture.h>
#include <grader/pipeline/Fit.h>
#include <grader/probe/AnswerMemory.h>
#include <grader/tasks/bump/BumpPicture.h>

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace ticker::pipeline {
namespace {

// An arbitrary constant, so that pictures are reproducible.
constexpr std::uint64_t kSpecSeed = 1;

raytracer::RenderSettings settingsOf(int width, int height) {
    raytracer::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.seed = kSpecSeed;
    return settings;
}

std::string add(Gallery& gallery, const std::string& file, const std::string& title,
                const raytracer::ByteImage& image) {
    gallery.pictures.push_back({"images/" + file + ".png", title, picture::encodePicture(image)});
    return gallery.pictures.back().file;
}

std::string titleOf(const SpecScene& scene, Rays rays) {
    const std::string title = scene.name + " as this submission renders it";
    return scene.isRandom && rays == Rays::few
               ? title + fmt::format(", with {} rays for each pixel", kFewRays)
               : title;
}

void addRender(Gallery& gallery, const SpecScene& scene, Rays rays, const Fit& compared,
               const raytracer::ByteImage& picture) {
    constexpr double kFullZ = 6.0;
    const raytracer::ByteImage& expected = compared.expected->picture;
    const metrics::Scores scores =
        metrics::score(metrics::viewOf(expected), metrics::viewOf(picture));
    const metrics::Map& errors = scores.errors;
    RenderScore render;
    render.scene = scene.name;
    render.width = picture.width;
    render.height = picture.height;
    render.flip = scores.flip;
    render.ssim = scores.ssim;
    render.gmsd = scores.gmsd;
    render.rmse = scores.rmse;
    render.image = add(gallery, scene.name, titleOf(scene, rays), picture);
    render.reference =
        add(gallery, "expected-" + scene.name, scene.name + " as it should be", expected);
    render.errorMap =
        add(gallery, "flip-" + scene.name, scene.name + ": where the two look different",
            {errors.width, errors.height, metrics::magma(errors)});
    if (!compared.z.map.values.empty()) {
        render.zMax = compared.z.value;
        render.zMap = add(
            gallery, scene.name + ".zmap",
            scene.name +
                ": where it is too dark (blue) or too bright (red) for noise, full at 6 standard "
                "errors",
            {errors.width, errors.height, metrics::blueWhiteRed(compared.z.map, kFullZ)});
    }
    gallery.scores.push_back(std::move(render));
}

/// The question beside the picture of a scene with a bumpy sphere.
struct Relief {
    std::size_t picture = 0;
    tasks::BumpPicture plan;
};

/// The largest misfit of pictures with a relief; empty if no scene has a relief, or if a picture is
/// missing.
/// @param answers  Answers to the questions beside the pictures, in the same order.
std::optional<double> worstMisfit(const std::vector<Relief>& reliefs,
                                  const std::vector<std::optional<raytracer::ByteImage>>& pictures,
                                  std::span<const probe::Answer> answers) {
    if (reliefs.empty()) return std::nullopt;
    double worst = 0.0;
    for (std::size_t i = 0; i < reliefs.size(); ++i) {
        const auto& picture = pictures[reliefs[i].picture];
        if (!picture) return std::nullopt;
        const auto& answer = std::get<probe::NormalAnswer>(answers[i]);
        worst = std::max(worst, tasks::bumpMisfit(reliefs[i].plan, answer, picture->rgb));
    }
    return worst;
}

}  // namespace

raytracer::RenderSettings settingsFor(const SpecScene& scene, Rays rays) {
    raytracer::RenderSettings settings = scene.settings;
    if (scene.isRandom && rays == Rays::few) settings.dofRayCount = kFewRays;
    return settings;
}

std::optional<raytracer::ByteImage> pictureFrom(const probe::RenderAnswer& answer) {
    if (answer.images.size() != 1 || answer.wrongSize) return std::nullopt;
    const std::vector<raytracer::ColourRGB>& pixels = answer.images.front();
    if (std::ranges::any_of(pixels, [](const auto& pixel) { return probe::isUnanswered(pixel); }))
        return std::nullopt;
    raytracer::Image image{answer.width, answer.height};
    std::size_t index = 0;
    for (int y = 0; y < answer.height; ++y)
        for (int x = 0; x < answer.width; ++x)
            image.set(x, y, pixels[index++]);
    return raytracer::toBytes(image);
}

std::vector<SpecScene> readSpecScenes(const std::filesystem::path& scenes,
                                      const std::filesystem::path& assets,
                                      const Exercise& exercise) {
    std::vector<SpecScene> result;
    for (const SceneEntry& entry : exercise.scenes)
        result.push_back({entry.name,
                          entry.file,
                          entry.isRandom,
                          entry.isHandedIn,
                          raytracer::readScene(scenes / (entry.name + ".xml"), assets),
                          settingsOf(entry.width, entry.height),
                          {},
                          {}});
    const auto later = [](auto work) { return std::async(std::launch::deferred, work).share(); };
    for (SpecScene& scene : result)
        if (!scene.isRandom)
            scene.expectations.push_back(
                later([description = scene.scene, settings = scene.settings] {
                    return expectPinhole(description, settings);
                }));
        else
            for (const oracle::Reading& reading : acceptedReadings()) {
                scene.readings.push_back(reading);
                scene.expectations.push_back(
                    later([description = scene.scene, settings = scene.settings, reading] {
                        return expectLens(description, settings, reading);
                    }));
            }
    return result;
}

std::vector<Rendered> Gallery::moveTo(SubmissionResult& result) && {
    std::ranges::move(scores, std::back_inserter(result.renders));
    std::ranges::move(pictures, std::back_inserter(result.pictures));
    return std::move(rendered);
}

Gallery renderSpecScenes(const std::vector<SpecScene>& scenes, std::string_view file,
                         probe::Examinee& examinee, Rays rays) {
    std::vector<const SpecScene*> asked;
    std::vector<probe::Question> questions;
    for (const SpecScene& scene : scenes) {
        if (scene.file != file) continue;
        asked.push_back(&scene);
        questions.emplace_back(probe::RenderQuestion{scene.scene, settingsFor(scene, rays), 1, 0});
    }
    Gallery gallery;
    if (questions.empty()) return gallery;
    std::vector<Relief> reliefs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (tasks::hasRelief(asked[i]->scene)) {
            reliefs.push_back({i, tasks::planBumpPicture(asked[i]->scene, asked[i]->settings)});
            questions.emplace_back(reliefs.back().plan.question);
        }
    const probe::Run run = examinee.ask(questions);
    std::vector<std::optional<raytracer::ByteImage>> pictures;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& answer = std::get<probe::RenderAnswer>(run.answers.at(i));
        pictures.push_back(pictureFrom(answer));
        if (!pictures[i]) continue;
        const Fit fit = bestFit(*asked[i], answer, rays);
        addRender(gallery, *asked[i], rays, fit, *pictures[i]);
        gallery.misfits.insert(gallery.misfits.end(), fit.misfits.begin(), fit.misfits.end());
        gallery.isClear = gallery.isClear && fit.isClear;
    }
    gallery.bumpMisfit =
        worstMisfit(reliefs, pictures, std::span(run.answers).subspan(pictures.size()));
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (pictures[i]) gallery.rendered.push_back({asked[i]->name, *std::move(pictures[i])});
    return gallery;
}

void prepareExpectations(const std::vector<SpecScene>& scenes, std::string_view file) {
    for (const SpecScene& scene : scenes)
        if (scene.file == file) static_cast<void>(scene.expected());
}

}  // namespace ticker::pipeline

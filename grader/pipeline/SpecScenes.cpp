#include <grader/pipeline/SpecScenes.h>

#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/picture/EncodePicture.h>
#include <grader/probe/AnswerMemory.h>
#include <grader/tasks/bump/BumpPicture.h>

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace ticker::pipeline {
namespace {

// Free to choose: it only makes pictures repeat.
constexpr std::uint64_t kSpecSeed = 1;

raytracer::RenderSettings settingsOf(int width, int height) {
    raytracer::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.seed = kSpecSeed;
    return settings;
}

/// An expectation beside a submission's picture, in standard errors.
struct Comparison {
    const Expectation* expected = nullptr;
    metrics::Measured z;
    double misfit = 0.0;
};

Comparison compare(const Expectation& expected, const probe::RenderAnswer& answer) {
    if (expected.brightness.mean.values.empty()) return {&expected, {}, 0.0};
    Comparison result{
        &expected,
        metrics::zMap(expected.brightness,
                      brightnessOf(answer.width, answer.height, answer.images[0]), 1.0),
        0.0};
    for (const float z : result.z.map.values)
        result.misfit += static_cast<double>(z) * static_cast<double>(z);
    result.misfit /= static_cast<double>(result.z.map.values.size());
    return result;
}

Comparison bestFitting(const SpecScene& scene, const probe::RenderAnswer& answer,
                       std::vector<tasks::Misfit>& misfits) {
    // What is farther off is no accepted reading of the light.
    constexpr double kNearMiss = 2.0;
    Comparison best = compare(scene.expected(), answer);
    double factor = 0.0;
    for (std::size_t i = 0; i < scene.readings.size(); ++i) {
        const bool isOfLight = i >= kAcceptedApertures.size();
        const double own = scene.readings[i].apertureFactor;
        if (i > 0 && best.misfit <= tasks::kMostMisfit) break;
        if (isOfLight && (best.misfit > kNearMiss || own != factor)) continue;
        Comparison other = compare(scene.expected(i), answer);
        misfits.push_back({own, other.misfit});
        if (i > 0 && other.misfit >= best.misfit) continue;
        best = std::move(other);
        factor = own;
    }
    return best;
}

std::string add(Gallery& gallery, const std::string& file, const std::string& title,
                const raytracer::ByteImage& image) {
    gallery.pictures.push_back({"images/" + file + ".png", title, picture::encodePicture(image)});
    return gallery.pictures.back().file;
}

void addRender(Gallery& gallery, const SpecScene& scene, const probe::RenderAnswer& answer,
               const raytracer::ByteImage& picture) {
    constexpr double kFullZ = 6.0;
    const Comparison compared = bestFitting(scene, answer, gallery.misfits);
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
    render.image = add(gallery, scene.name, scene.name + " as this submission renders it", picture);
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

/// The largest misfit of option 1's pictures; empty where one did not come.
/// @param answers  To what was asked beside the pictures, in the same order.
std::optional<double> worstMisfit(const std::vector<tasks::BumpPicture>& plans,
                                  const std::vector<std::optional<raytracer::ByteImage>>& pictures,
                                  std::span<const probe::Answer> answers) {
    double worst = 0.0;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (!pictures[i]) return std::nullopt;
        const auto& answer = std::get<probe::NormalAnswer>(answers[i]);
        worst = std::max(worst, tasks::bumpMisfit(plans[i], answer, pictures[i]->rgb));
    }
    return worst;
}

}  // namespace

std::vector<tasks::Misfit> misfitsOf(const SpecScene& scene, const probe::RenderAnswer& answer) {
    std::vector<tasks::Misfit> misfits;
    static_cast<void>(bestFitting(scene, answer, misfits));
    return misfits;
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
                                      const std::filesystem::path& assets) {
    const auto read = [&](const char* name) {
        return raytracer::readScene(scenes / (std::string{name} + ".xml"), assets);
    };
    std::vector<SpecScene> result;
    for (const char* name : {"bump-mapping", "bumpmap-test"})
        result.push_back({name, true, true, read(name), settingsOf(320, 240), {}, {}});
    result.back().isHandedIn = false;
    result.push_back(
        {"distributed", false, true, read("distributed"), settingsOf(160, 120), {}, {}});
    const auto later = [](auto work) { return std::async(std::launch::deferred, work).share(); };
    for (SpecScene& scene : result)
        if (scene.isForT1)
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

Gallery renderSpecScenes(const std::vector<SpecScene>& scenes, bool isT1,
                         probe::Examinee& examinee) {
    std::vector<const SpecScene*> asked;
    std::vector<probe::Question> questions;
    for (const SpecScene& scene : scenes) {
        if (scene.isForT1 != isT1) continue;
        asked.push_back(&scene);
        questions.emplace_back(probe::RenderQuestion{scene.scene, scene.settings, 1, 0});
    }
    Gallery gallery;
    if (questions.empty()) return gallery;
    std::vector<tasks::BumpPicture> bumps;
    for (const SpecScene* scene : asked)
        if (isT1) {
            bumps.push_back(tasks::planBumpPicture(scene->scene, scene->settings));
            questions.emplace_back(bumps.back().question);
        }
    const probe::Sitting sitting = examinee.ask(questions);
    std::vector<std::optional<raytracer::ByteImage>> pictures;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& answer = std::get<probe::RenderAnswer>(sitting.answers.at(i));
        pictures.push_back(pictureFrom(answer));
        if (pictures[i]) addRender(gallery, *asked[i], answer, *pictures[i]);
    }
    if (isT1)
        gallery.bumpMisfit =
            worstMisfit(bumps, pictures, std::span(sitting.answers).subspan(pictures.size()));
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (pictures[i]) gallery.rendered.push_back({asked[i]->name, *std::move(pictures[i])});
    return gallery;
}

void prepareExpectations(const std::vector<SpecScene>& scenes, bool isT1) {
    for (const SpecScene& scene : scenes)
        if (scene.isForT1 == isT1) static_cast<void>(scene.expected());
}

}  // namespace ticker::pipeline

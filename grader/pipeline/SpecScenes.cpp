#include <grader/pipeline/SpecScenes.h>

#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/oracle/References.h>
#include <grader/probe/AnswerMemory.h>

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace ticker::pipeline {
namespace {

// Free to choose: it only makes pictures repeat.
constexpr std::uint64_t kSeed = 1;

raytracer::RenderSettings settingsOf(int width, int height) {
    raytracer::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.seed = kSeed;
    return settings;
}

metrics::ByteView viewOf(const raytracer::ByteImage& image) {
    return {image.width, image.height, image.rgb};
}

void addRender(SubmissionResult& result, const SpecScene& scene,
               const raytracer::ByteImage& picture) {
    const metrics::Scores scores = metrics::score(viewOf(scene.expected), viewOf(picture));
    RenderScore render;
    render.scene = scene.name;
    render.width = picture.width;
    render.height = picture.height;
    render.flip = scores.flip;
    render.ssim = scores.ssim;
    render.gmsd = scores.gmsd;
    render.rmse = scores.rmse;
    render.image = "images/" + scene.name + ".png";
    render.reference = "images/expected-" + scene.name + ".png";
    result.pictures.push_back({render.image, scene.name + " as this submission renders it",
                               raytracer::encodePng(picture)});
    result.pictures.push_back(
        {render.reference, scene.name + " as it should be", raytracer::encodePng(scene.expected)});
    render.errorMap = "images/flip-" + scene.name + ".png";
    const metrics::Map& errors = scores.errors;
    result.pictures.push_back(
        {render.errorMap, scene.name + ": where the two look different",
         raytracer::encodePng({errors.width, errors.height, metrics::magma(errors)})});
    result.renders.push_back(std::move(render));
}

}  // namespace

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
        result.push_back({name, true, read(name), settingsOf(320, 240), {}});
    result.push_back({"distributed", false, read("distributed"), settingsOf(160, 120), {}});
    for (SpecScene& scene : result)
        scene.expected = raytracer::toBytes(
            scene.isForT1 ? oracle::renderPinholeWithOracle(scene.scene, scene.settings)
                          : oracle::renderWithOracle(scene.scene, scene.settings, kSeed));
    return result;
}

void addRenders(SubmissionResult& result, const std::vector<SpecScene>& scenes, bool isT1,
                probe::Examinee& examinee) {
    std::vector<const SpecScene*> asked;
    std::vector<probe::Question> questions;
    for (const SpecScene& scene : scenes) {
        if (scene.isForT1 != isT1) continue;
        asked.push_back(&scene);
        questions.emplace_back(probe::RenderQuestion{scene.scene, scene.settings, 1, 0});
    }
    if (questions.empty()) return;
    const probe::Sitting sitting = examinee.ask(questions);
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (const auto picture = pictureFrom(std::get<probe::RenderAnswer>(sitting.answers.at(i))))
            addRender(result, *asked[i], *picture);
}

}  // namespace ticker::pipeline

#include <grader/pipeline/SpecScenes.h>

#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/oracle/Oracle.h>
#include <grader/oracle/References.h>
#include <grader/picture/EncodePicture.h>
#include <grader/probe/AnswerMemory.h>

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ticker::pipeline {
namespace {

// Free to choose: it only makes pictures repeat.
constexpr std::uint64_t kSeed = 1;
// As the student's picture tells brightness from colour in nothing here, any weights will do.
constexpr raytracer::ColourRGB kBrightness{0.25, 0.5, 0.25};

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

metrics::Map brightnessOf(int width, int height, const std::vector<raytracer::ColourRGB>& pixels) {
    metrics::Map map{width, height, {}};
    for (const raytracer::ColourRGB& pixel : pixels)
        map.values.push_back(static_cast<float>(kBrightness.r * pixel.r + kBrightness.g * pixel.g +
                                                kBrightness.b * pixel.b));
    return map;
}

Expectation expectPinhole(const raytracer::SceneDescription& scene,
                          const raytracer::RenderSettings& settings) {
    return {raytracer::toBytes(oracle::renderPinholeWithOracle(scene, settings)), {}};
}

Expectation expectLens(const raytracer::SceneDescription& scene,
                       const raytracer::RenderSettings& settings, double apertureFactor) {
    oracle::Reading reading;
    reading.apertureFactor = apertureFactor;
    oracle::Precision precision;
    precision.share = 0.0;
    precision.rms = 5e-4;  // a tenth of a step of a byte
    const oracle::Moments moments =
        oracle::Oracle{scene, settings, reading}.moments(kSeed, precision);

    Expectation expected;
    raytracer::Image image{moments.width, moments.height};
    for (int y = 0; y < moments.height; ++y)
        for (int x = 0; x < moments.width; ++x)
            image.set(x, y, moments.mean[static_cast<std::size_t>(y * moments.width + x)]);
    expected.picture = raytracer::toBytes(image);
    expected.brightness.renders = 1.0 / moments.shareOfVariance(1);
    expected.brightness.mean = brightnessOf(moments.width, moments.height, moments.mean);
    expected.brightness.variance = {moments.width, moments.height, {}};
    for (const oracle::Covariance& covariance : moments.covariance)
        expected.brightness.variance.values.push_back(
            static_cast<float>(covariance.along(kBrightness)));
    return expected;
}

/// An expectation beside a submission's picture, in standard errors.
struct Comparison {
    const Expectation* expected = nullptr;
    metrics::Measured z;
    double total = 0.0;  ///< of all squares: how badly it fits
};

Comparison compare(const Expectation& expected, const probe::RenderAnswer& answer) {
    if (expected.brightness.mean.values.empty()) return {&expected, {}, 0.0};
    Comparison result{
        &expected,
        metrics::zMap(expected.brightness,
                      brightnessOf(answer.width, answer.height, answer.images[0]), 1.0),
        0.0};
    for (const float z : result.z.map.values)
        result.total += static_cast<double>(z) * static_cast<double>(z);
    return result;
}

Comparison bestFitting(const SpecScene& scene, const probe::RenderAnswer& answer) {
    constexpr double kFits = 1.5;  // mean square of a pixel's z; 1 where everything is right
    Comparison best = compare(scene.expected(), answer);
    for (std::size_t i = 1; i < scene.expectations.size(); ++i) {
        if (best.total < kFits * answer.width * answer.height) break;
        if (Comparison other = compare(scene.expected(i), answer); other.total < best.total)
            best = std::move(other);
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
    const Comparison compared = bestFitting(scene, answer);
    const raytracer::ByteImage& expected = compared.expected->picture;
    const metrics::Scores scores = metrics::score(viewOf(expected), viewOf(picture));
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
        gallery.misfit = compared.total / static_cast<double>(compared.z.map.values.size());
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
        result.push_back({name, true, true, read(name), settingsOf(320, 240), {}});
    result.back().isHandedIn = false;
    result.push_back({"distributed", false, true, read("distributed"), settingsOf(160, 120), {}});
    const auto later = [](auto work) { return std::async(std::launch::deferred, work).share(); };
    for (SpecScene& scene : result)
        if (scene.isForT1)
            scene.expectations.push_back(
                later([description = scene.scene, settings = scene.settings] {
                    return expectPinhole(description, settings);
                }));
        else
            for (const double apertureFactor : {1.0, 0.5})
                scene.expectations.push_back(
                    later([description = scene.scene, settings = scene.settings, apertureFactor] {
                        return expectLens(description, settings, apertureFactor);
                    }));
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
    const probe::Sitting sitting = examinee.ask(questions);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& answer = std::get<probe::RenderAnswer>(sitting.answers.at(i));
        std::optional<raytracer::ByteImage> picture = pictureFrom(answer);
        if (!picture) continue;
        addRender(gallery, *asked[i], answer, *picture);
        gallery.rendered.push_back({asked[i]->name, *std::move(picture)});
    }
    return gallery;
}

void prepareExpectations(const std::vector<SpecScene>& scenes, bool isT1) {
    for (const SpecScene& scene : scenes)
        if (scene.isForT1 == isT1) static_cast<void>(scene.expected());
}

}  // namespace ticker::pipeline

#include <grader/tasks/screenshot/Relief.h>

#include <grader/metrics/Alignment.h>
#include <grader/oracle/references/References.h>

#include <raytracer/image/ToneCurve.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

// The lens blurs finer structures; coarser ones are the ball's shading.
constexpr int kFineWidth = 80;
constexpr int kFineHeight = 60;
constexpr int kCoarser = 4;

constexpr double kSameMap = 0.3;

std::vector<double> detailOf(const ByteView& picture) {
    const Picture fine = metrics::resized(picture, kFineWidth, kFineHeight);
    const Picture coarse = metrics::resized(
        metrics::resized(picture, kFineWidth / kCoarser, kFineHeight / kCoarser).view(), kFineWidth,
        kFineHeight);
    std::vector<double> detail;
    for (std::size_t i = 0; i < fine.rgb.size(); i += 3) {
        double sum = 0.0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += fine.rgb[i + channel] - coarse.rgb[i + channel];
        detail.push_back(sum);
    }
    return detail;
}

Picture withoutRelief(const Scene& scene) {
    raytracer::SceneDescription smooth = *scene.description;
    for (raytracer::SphereDescription& sphere : smooth.spheres)
        sphere.heightMap = nullptr;
    raytracer::RenderSettings settings;
    settings.width = 4 * kFineWidth;
    settings.height = 4 * kFineHeight;
    const raytracer::Image image = oracle::renderPinholeWithOracle(smooth, settings);
    Picture picture{settings.width, settings.height, {}};
    for (const raytracer::ColourRGB& colour : image.pixels())
        for (const std::uint8_t byte : raytracer::toneMapped(colour))
            picture.rgb.push_back(byte);
    return picture;
}

}  // namespace

Relief reliefOf(const ByteView& picture, const Scene& scene) {
    const std::vector<double> seen = detailOf(picture);
    const std::vector<double> own = detailOf(scene.own);
    const std::vector<double> smooth = detailOf(withoutRelief(scene).view());
    double both = 0.0;
    double ofSeen = 0.0;
    double ofOwn = 0.0;
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        const double first = seen[i] - smooth[i];
        const double second = own[i] - smooth[i];
        both += first * second;
        ofSeen += first * first;
        ofOwn += second * second;
    }
    if (ofSeen <= 0.0 || ofOwn <= 0.0) return {};
    return {both / std::sqrt(ofSeen * ofOwn), std::sqrt(ofSeen / ofOwn)};
}

bool isSame(const Relief& relief) {
    // The wrong sign with the largest likeness is an inverted longitude: 0.65.
    constexpr double kSameCode = 0.85;
    return relief.likeness >= kSameCode;
}

bool isSofter(const Relief& relief) {
    constexpr double kWeaker = 0.75;
    return relief.likeness >= kSameMap && relief.strength <= kWeaker;
}

bool isRather(const Relief& here, const Relief& there) {
    return here.likeness >= kSameMap && here.likeness >= 2.0 * there.likeness;
}

}  // namespace ticker::tasks::screenshot

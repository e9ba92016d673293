#include <grader/oracle/references/HiddenScene.h>
#include <grader/oracle/Oracle.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ticker::oracle {
namespace {

using raytracer::ColourRGB;

// Rec. 709, as everywhere in the kit.
constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722};
// Paths of one of the two independent estimates.
constexpr int kPaths = 128;
// Student code may differ from the oracle this much by its choice of bias or precision; no
// smaller deviation counts.
constexpr double kFloor = 1e-3;

double luminance(const ColourRGB& c) {
    return kLuminance[0] * c.r + kLuminance[1] * c.g + kLuminance[2] * c.b;
}

/// Two independent estimates: a product of their differences is right on average, where a square
/// would count the estimates' own noise.
struct Twice {
    Moments first, second;
};

Twice twice(HiddenTask task, const raytracer::SceneDescription& scene,
            raytracer::RenderSettings settings, KnownMistake model) {
    Precision precision;
    precision.minLensPaths = precision.maxLensPaths = kPaths;
    if (task == HiddenTask::bump) {
        settings.dofRayCount = settings.shadowRayCount = 1;
        model.reading.lightShape = LightShape::centre;
        model.mistake.aperture = Mistake::Aperture::none;
        precision.minLensPaths = precision.maxLensPaths = 4;
    }
    const Oracle oracle{scene, settings, model.reading, model.mistake};
    return {oracle.moments(1, precision), oracle.moments(2, precision)};
}

double separation(HiddenTask task, const Twice& right, const Twice& wrong) {
    double sum = 0.0;
    double light = 0.0;
    for (std::size_t i = 0; i < right.first.mean.size(); ++i) {
        const double one = luminance(wrong.first.mean[i] - right.first.mean[i]);
        const double other = luminance(wrong.second.mean[i] - right.second.mean[i]);
        const double variance =
            right.first.covariance[i].along({kLuminance[0], kLuminance[1], kLuminance[2]});
        const double scale = task == HiddenTask::bump ? 1.0 : variance + kFloor * kFloor;
        sum += one * other / scale;
        light += luminance(right.first.mean[i]) * luminance(right.second.mean[i]);
    }
    return std::sqrt(std::max(0.0, sum) / (task == HiddenTask::bump ? light : 1.0));
}

}  // namespace

std::vector<KnownMistake> knownMistakes(HiddenTask task) {
    std::vector<KnownMistake> list;
    const auto add = [&](const char* finding, const auto& change) {
        KnownMistake known{finding, {}, {}};
        change(known);
        list.push_back(known);
    };
    switch (task) {
        case HiddenTask::bump:
            add("bump.flat",
                [](KnownMistake& k) { k.reading.bump.gainU = k.reading.bump.gainV = 0.0; });
            add("bump.swapped-axes", [](KnownMistake& k) { k.reading.bump.swapped = true; });
            add("bump.inverted",
                [](KnownMistake& k) { k.reading.bump.gainU = k.reading.bump.gainV = -1.0; });
            add("bump.inverted-u", [](KnownMistake& k) { k.reading.bump.gainU = -1.0; });
            add("bump.inverted-v", [](KnownMistake& k) { k.reading.bump.gainV = -1.0; });
            break;
        case HiddenTask::softShadows:
            add("shadow.hard", [](KnownMistake& k) { k.reading.lightShape = LightShape::centre; });
            add("shadow.light-size", [](KnownMistake& k) { k.mistake.lightSizeFactor = 0.75; });
            add("shadow.not-a-ball",
                [](KnownMistake& k) { k.reading.lightShape = LightShape::cube; });
            add("shadow.all-or-nothing", [](KnownMistake& k) { k.mistake.allOrNothing = true; });
            add("shadow.ambient-scaled", [](KnownMistake& k) { k.mistake.ambientScaled = true; });
            add("shadow.diffuse-unshadowed",
                [](KnownMistake& k) { k.mistake.diffuseUnshadowed = true; });
            break;
        case HiddenTask::depthOfField:
            add("dof.none", [](KnownMistake& k) { k.mistake.aperture = Mistake::Aperture::none; });
            add("dof.disc", [](KnownMistake& k) { k.mistake.aperture = Mistake::Aperture::disc; });
            add("dof.aperture-size", [](KnownMistake& k) { k.reading.apertureFactor = 1.5; });
            add("dof.off-centre",
                [](KnownMistake& k) { k.mistake.lensOffsetX = k.mistake.lensOffsetY = 1.0; });
            add("dof.focal-distance", [](KnownMistake& k) { k.mistake.focalByDistance = true; });
            add("dof.focal-plane", [](KnownMistake& k) { k.mistake.focalFactor = 1.2; });
            break;
    }
    return list;
}

double leastSeparation(HiddenTask task) {
    switch (task) {
        case HiddenTask::bump:
            return 0.25;
        case HiddenTask::softShadows:
        case HiddenTask::depthOfField:
            return 8.0;
    }
    return 0.0;
}

std::vector<Separation> separationsOf(HiddenTask task, const raytracer::SceneDescription& scene,
                                      const raytracer::RenderSettings& settings) {
    const Twice right = twice(task, scene, settings, {});
    std::vector<Separation> result;
    for (const KnownMistake& known : knownMistakes(task))
        result.push_back(
            {known.finding, separation(task, right, twice(task, scene, settings, known))});
    return result;
}

}  // namespace ticker::oracle

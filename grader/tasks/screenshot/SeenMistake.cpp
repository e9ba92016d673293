#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/screenshot/SeenMistake.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <grader/metrics/NoiseEnergy.h>
#include <grader/oracle/Oracle.h>
#include <grader/tasks/screenshot/Agreement.h>

#include <raytracer/image/ToneCurve.h>

#include <array>
#include <tuple>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

using oracle::Mistake;
using oracle::Reading;

/// One hypothesis about a picture: its words, and what the oracle renders for it.
struct Candidate {
    SeenMistake seen;
    Reading reading;
    Mistake mistake;
};

template <class Change>
Candidate make(std::string_view id, const char* words, const Change& change) {
    Candidate candidate{{std::string{id}, words}, {}, {}};
    change(candidate.reading, candidate.mistake);
    return candidate;
}

// Pinhole camera and hard shadows, as in the template, with which pictures of bump maps are made.
void asPinhole(Reading& reading, Mistake& mistake) {
    reading.lightShape = oracle::LightShape::centre;
    mistake.aperture = Mistake::Aperture::none;
}

std::vector<Candidate> rightPictures() {
    using oracle::LightShape;
    const auto none = [](Reading&, Mistake&) {};
    std::vector<Candidate> all{make("", "what the handout asks for", none)};
    for (const LightShape shape :
         {LightShape::surface, LightShape::uniformRadius, LightShape::polarHelper})
        all.push_back(make("", "what the handout asks for",
                           [&](Reading& r, Mistake&) { r.lightShape = shape; }));
    all.push_back(make("", "what the handout asks for",
                       [](Reading& r, Mistake&) { r.phong = oracle::PhongReading::perSample; }));
    return all;
}

std::vector<Candidate> wrongShadows() {
    std::vector<Candidate> all;
    const auto add = [&](const FindingText& text, const char* words, const auto& change) {
        all.push_back(make(text.id, words, change));
    };
    add(kShadowHard, "hard shadows",
        [](Reading& r, Mistake&) { r.lightShape = oracle::LightShape::centre; });
    for (const double size : {0.5, 2.0})
        add(kShadowLightSize, "shadows of a light of another size",
            [&](Reading&, Mistake& m) { m.lightSizeFactor = size; });
    add(kShadowInverted, "lit and shadowed exchanged",
        [](Reading&, Mistake& m) { m.shadowInverted = true; });
    add(kShadowAllOrNothing, "shadows without a fraction",
        [](Reading&, Mistake& m) { m.allOrNothing = true; });
    add(kShadowAmbientScaled, "shadows on the ambient light",
        [](Reading&, Mistake& m) { m.ambientScaled = true; });
    add(kShadowSpecularUnshadowed, "highlights in the shadow",
        [](Reading&, Mistake& m) { m.specularUnshadowed = true; });
    add(kShadowDiffuseUnshadowed, "diffuse light in the shadow",
        [](Reading&, Mistake& m) { m.diffuseUnshadowed = true; });
    add(kShadowDirectionOffset, "shadows that widen with the light's distance",
        [](Reading&, Mistake& m) { m.directionOffset = true; });
    return all;
}

std::vector<Candidate> wrongLenses() {
    std::vector<Candidate> all;
    const auto add = [&](const FindingText& text, const char* words, const auto& change) {
        all.push_back(make(text.id, words, change));
    };
    add(kDofNone, "everything sharp",
        [](Reading&, Mistake& m) { m.aperture = Mistake::Aperture::none; });
    add(kDofNone, "everything sharp, and hard shadows", asPinhole);
    add(kDofFocalDistance, "a sharp surface that is a ball around the eye",
        [](Reading&, Mistake& m) { m.focalByDistance = true; });
    for (const double focal : {0.85, 1.2})
        add(kDofFocalPlane, "another plane sharp",
            [&](Reading&, Mistake& m) { m.focalFactor = focal; });
    add(kDofOffCentre, "an aperture that is not centred on the eye",
        [](Reading&, Mistake& m) { m.lensOffsetX = m.lensOffsetY = 1.0; });
    add(kDofDisc, "an aperture that is a disc",
        [](Reading&, Mistake& m) { m.aperture = Mistake::Aperture::disc; });
    for (const double size : {0.7, 1.4})
        add(kDofApertureSize, "an aperture of another size",
            [&](Reading& r, Mistake&) { r.apertureFactor *= size; });
    return all;
}

Picture render(const Candidate& candidate, const Scene& scene, const Windows& windows,
               bool isPinhole, std::uint64_t seed) {
    Picture strip{windows.boxes.front().width, 0, {}};
    for (const metrics::Box& box : windows.boxes) {
        raytracer::RenderSettings settings;
        settings.width = windows.frameWidth;
        settings.height = windows.frameHeight;
        settings.region = {box.x, box.y, box.width, box.height};
        if (isPinhole) settings.dofRayCount = settings.shadowRayCount = 1;
        const oracle::Oracle renderer{*scene.description, settings, candidate.reading,
                                      candidate.mistake};
        const raytracer::Image image = renderer.studentRender(seed++);
        for (const raytracer::ColourRGB& colour : image.pixels())
            for (const std::uint8_t byte : raytracer::toneMapped(colour))
                strip.rgb.push_back(byte);
        strip.height += box.height;
    }
    return strip;
}

std::optional<SeenMistake> distributedMistake(const ByteView& picture, const Scene& scene,
                                              const Windows& windows, std::uint64_t seed) {
    constexpr double kByFar = 0.35;
    std::vector<Candidate> all = rightPictures();
    for (std::vector<Candidate>& more : std::array{wrongShadows(), wrongLenses()})
        all.insert(all.end(), more.begin(), more.end());
    std::optional<SeenMistake> best;
    metrics::NoiseEnergy least;
    double right = 0.0;
    for (const double aperture : {1.0, 0.5})
        for (Candidate candidate : all) {
            candidate.reading.apertureFactor *= aperture;
            const Picture rendered = render(candidate, scene, windows, false, seed);
            const metrics::NoiseEnergy energy = metrics::noiseEnergy(rendered.view(), picture);
            if (candidate.seen.id.empty() && (right == 0.0 || energy.energy < right))
                right = energy.energy;
            if (best && energy.energy >= least.energy) continue;
            best = candidate.seen;
            least = energy;
        }
    const bool isClear = least.probability() >= kSmallestChance || least.energy < kByFar * right;
    return isClear ? best : std::nullopt;
}

/// The readings of a bump map whose pictures differ most, and the mistake of each.
std::vector<Candidate> bumpPictures() {
    std::vector<Candidate> all;
    for (const double origin : {0.0, 0.25, 0.5, 0.75})
        for (const bool isMirrored : {false, true})
            for (const auto& [u, v, id, words] :
                 {std::tuple{1.0, 1.0, std::string_view{}, "what the handout asks for"},
                  std::tuple{-1.0, -1.0, kBumpInverted.id, "a relief that is inverted"},
                  std::tuple{-1.0, 1.0, kBumpInvertedU.id, "a relief that is inverted along u"},
                  std::tuple{1.0, -1.0, kBumpInvertedV.id, "a relief that is inverted along v"}}) {
                all.push_back(make(id, words, asPinhole));
                all.back().reading.bump.uOrigin = origin;
                all.back().reading.bump.mirrored = isMirrored;
                all.back().reading.bump.gainU = u;
                all.back().reading.bump.gainV = v;
            }
    all.push_back(make(kBumpFlat.id, "a smooth ball", asPinhole));
    all.back().reading.bump.gainU = all.back().reading.bump.gainV = 0.0;
    return all;
}

// Strength, interpolation and differences vary between solutions; the lit side of a bump does not.
std::optional<SeenMistake> bumpMistake(const ByteView& picture, const Scene& scene,
                                       const Windows& windows, std::uint64_t seed) {
    constexpr double kLikeEnough = 0.8;
    std::optional<SeenMistake> best;
    double most = kLikeEnough;
    for (const Candidate& candidate : bumpPictures()) {
        const Picture rendered = render(candidate, scene, windows, true, seed);
        const double likeness = metrics::correlation(rendered.view(), picture);
        if (likeness <= most) continue;
        best = candidate.seen;
        most = likeness;
    }
    return best;
}

}  // namespace

std::optional<SeenMistake> seenMistake(const ByteView& windowsOfPicture, const Scene& scene,
                                       const Windows& windows, std::uint64_t seed) {
    return !scene.isRandom ? bumpMistake(windowsOfPicture, scene, windows, seed)
                           : distributedMistake(windowsOfPicture, scene, windows, seed);
}

}  // namespace ticker::tasks::screenshot

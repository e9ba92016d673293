#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/PictureSuspects.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

using oracle::Mistake;
using oracle::Reading;

Suspect suspect(const FindingText& text, const char* seen, double factor, const Mistake& mistake) {
    Reading reading;
    reading.apertureFactor = factor;
    return {&text, seen, reading, mistake, false};
}

// The mean under the suspect's mistake.
Plane pictureOf(const Suspect& suspect, probe::RenderQuestion asked, std::uint64_t seed) {
    if (suspect.withoutBounces) asked.settings.bounces = 0;
    return mistakenPicture(asked, suspect.reading, suspect.mistake, seed);
}

struct Tried {
    const Suspect* suspect = nullptr;
    Match match;
    double leaves = 1.0;
};

// The one whose filter answers loudest. Filters of like shape answer alike: then the one whose
// whole difference is there, rather than a part of it or more.
const Tried* bestOf(const std::vector<Tried>& tried) {
    constexpr double kAlike = 0.85;
    double loudest = 0.0;
    for (const Tried& one : tried)
        loudest = std::max(loudest, one.match.z);
    const Tried* best = nullptr;
    for (const Tried& one : tried) {
        if (one.match.z <= 0.0 || one.match.z < kAlike * loudest) continue;
        if (best == nullptr ||
            std::abs(one.match.amplitude - 1.0) < std::abs(best->match.amplitude - 1.0))
            best = &one;
    }
    return best;
}

}  // namespace

std::vector<Suspect> suspectsFor(double factor) {
    std::vector<Suspect> suspects;
    const auto with = [](auto change) {
        Mistake mistake;
        change(mistake);
        return mistake;
    };
    suspects.push_back(suspect(kDofNone, "everything is sharp", factor,
                               with([](Mistake& m) { m.aperture = Mistake::Aperture::none; })));
    suspects.push_back(suspect(kDofFocalDistance,
                               "the sharp surface is a ball around the eye, not a plane", factor,
                               with([](Mistake& m) { m.focalByDistance = true; })));
    for (const double focal : {0.85, 1.2})
        suspects.push_back(suspect(kDofFocalPlane, "another plane is sharp", factor,
                                   with([&](Mistake& m) { m.focalFactor = focal; })));
    suspects.push_back(
        suspect(kDofOffCentre, "things out of focus are shifted", factor, with([](Mistake& m) {
                    m.lensOffsetX = 1.0;
                    m.lensOffsetY = 1.0;
                })));
    suspects.push_back(suspect(kDofOffCentre, "things out of focus are shifted", 0.5 * factor,
                               with([](Mistake& m) {
                                   m.lensOffsetX = 1.0;
                                   m.lensOffsetY = 1.0;
                               })));
    suspects.push_back(suspect(kDofDisc, "the blur has the shape of a disc", factor,
                               with([](Mistake& m) { m.aperture = Mistake::Aperture::disc; })));
    for (const double size : {0.7, 1.4})
        suspects.push_back(suspect(kDofApertureSize, "the blur has another size", size * factor,
                                   with([](Mistake&) {})));
    suspects.push_back(suspect(kDofNotAveraged, "it is too bright or too dark", factor,
                               with([](Mistake& m) { m.pixelScale = 1.1; })));
    suspects.push_back(suspect(kDofWrong, "it lacks the reflections", factor, {}));
    suspects.back().withoutBounces = true;
    return suspects;
}

Bank tryAll(const std::vector<Suspect>& suspects, const probe::RenderQuestion& asked,
            const SeenPictures& seen, const ExpectedPicture& expected, std::uint64_t seed) {
    Bank bank;
    std::vector<Tried> tried;
    for (const Suspect& suspect : suspects) {
        const Plane mistaken = pictureOf(suspect, asked, seed);
        const Match match = matchOf(seen, expected, mistaken);
        bank.largest = std::max(bank.largest, std::abs(match.z));
        bank.squares += match.z * match.z;
        bank.spread = std::max(bank.spread, match.spread);
        tried.push_back({&suspect, match, unexplainedBy(mistaken, seen, expected)});
    }
    const Tried* best = bestOf(tried);
    if (best == nullptr) return bank;
    bank.best = best->suspect;
    bank.bestMatch = best->match;
    bank.bestLeaves = best->leaves;
    double second = 0.0;
    for (const Tried& one : tried) {
        const bool sameName = one.suspect->text == bank.best->text;
        if (sameName || one.match.z <= second) continue;
        bank.second = one.suspect;
        second = one.match.z;
    }
    return bank;
}

}  // namespace ticker::tasks

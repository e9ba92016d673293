#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

using oracle::Mistake;
using oracle::Reading;

PictureMistake seenMistake(const FindingText& text, const char* seen, const Reading& reading,
                           const Mistake& mistake) {
    return {&text, seen, reading, mistake, false};
}

Reading withAperture(Reading reading, double times) {
    reading.apertureFactor *= times;
    return reading;
}

struct Tried {
    const PictureMistake* mistake = nullptr;
    Match match;
    double leaves = 1.0;
};

// The mistake whose matched filter gives the largest z. Filters of similar shape give similar z:
// among them the one with an amplitude nearest to 1.
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

std::vector<PictureMistake> pictureMistakes(const Reading& accepted) {
    std::vector<PictureMistake> mistakes;
    const auto with = [](auto change) {
        Mistake mistake;
        change(mistake);
        return mistake;
    };
    mistakes.push_back(seenMistake(kDofNone, "everything is sharp", accepted,
                                   with([](Mistake& m) { m.aperture = Mistake::Aperture::none; })));
    mistakes.push_back(seenMistake(kDofFocalDistance,
                                   "the sharp surface is a ball around the eye, not a plane",
                                   accepted, with([](Mistake& m) { m.focalByDistance = true; })));
    for (const double focal : {0.85, 1.2})
        mistakes.push_back(seenMistake(kDofFocalPlane, "another plane is sharp", accepted,
                                       with([&](Mistake& m) { m.focalFactor = focal; })));
    mistakes.push_back(seenMistake(kDofOffCentre, "things out of focus are shifted", accepted,
                                   with([](Mistake& m) {
                                       m.lensOffsetX = 1.0;
                                       m.lensOffsetY = 1.0;
                                   })));
    mistakes.push_back(seenMistake(kDofOffCentre, "things out of focus are shifted",
                                   withAperture(accepted, 0.5), with([](Mistake& m) {
                                       m.lensOffsetX = 1.0;
                                       m.lensOffsetY = 1.0;
                                   })));
    mistakes.push_back(seenMistake(kDofDisc, "the blur has the shape of a disc", accepted,
                                   with([](Mistake& m) { m.aperture = Mistake::Aperture::disc; })));
    for (const double size : {0.7, 1.4})
        mistakes.push_back(seenMistake(kDofApertureSize, "the blur has another size",
                                       withAperture(accepted, size), with([](Mistake&) {})));
    mistakes.push_back(seenMistake(kDofNotAveraged, "it is too bright or too dark", accepted,
                                   with([](Mistake& m) { m.pixelScale = 1.1; })));
    mistakes.push_back(seenMistake(kDofWrong, "it lacks the reflections", accepted, {}));
    mistakes.back().withoutBounces = true;
    return mistakes;
}

Plane templateOf(const PictureMistake& mistake, probe::RenderQuestion asked, std::uint64_t seed,
                 Exactness exactness) {
    if (mistake.withoutBounces) asked.settings.bounces = 0;
    return mistakenPicture(asked, mistake.reading, mistake.mistake, seed, exactness);
}

// A twentieth of the mistake is negligible. Some patterns of lens points have a bias of that order:
// the canonical multi-jittered one (Kensler, "Correlated Multi-Jittered Sampling", 2013) looks off
// centre by a thirtieth of the lens.
double beyondNegligible(const Match& match) {
    constexpr double kNegligible = 0.05;
    const double amplitude = std::abs(match.amplitude);
    if (amplitude <= kNegligible) return 0.0;
    return std::abs(match.z) * (1.0 - kNegligible / amplitude);
}

Bank tryAll(const std::vector<PictureMistake>& mistakes, const Templates& templates,
            const SeenPictures& seen, const ExpectedPicture& expected) {
    Bank bank;
    std::vector<Tried> tried;
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        const PictureMistake& mistake = mistakes[i];
        const Plane& mistaken = templates(i);
        const Match match = matchOf(seen, expected, mistaken);
        bank.largest = std::max(bank.largest, std::abs(match.z));
        bank.beyond = std::max(bank.beyond, beyondNegligible(match));
        bank.squares += match.z * match.z;
        bank.spread = std::max(bank.spread, match.spread);
        tried.push_back({&mistake, match, unexplainedBy(mistaken, seen, expected)});
    }
    const Tried* best = bestOf(tried);
    if (best == nullptr) return bank;
    bank.best = best->mistake;
    bank.bestMatch = best->match;
    bank.bestLeaves = best->leaves;
    double second = 0.0;
    for (const Tried& one : tried) {
        const bool sameName = one.mistake->text == bank.best->text;
        if (sameName || one.match.z <= second) continue;
        bank.second = one.mistake;
        second = one.match.z;
    }
    return bank;
}

}  // namespace ticker::tasks

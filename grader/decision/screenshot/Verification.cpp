#include <grader/decision/screenshot/Verification.h>

#include <grader/decision/screenshot/Windows.h>

#include <utility>

namespace ticker::decision::screenshot {
namespace {

Verification unknown(const char* why) {
    return {Verification::Kind::unknown, why, {}, {}};
}

Verification compareOnce(const ByteView& picture, const Scene& scene, std::uint64_t seed,
                         int stage) {
    const Windows windows = drawWindows(scene.isForT1, picture.width, picture.height, seed, stage);
    std::optional<Picture> own =
        renderWindows(scene, windows, seed + static_cast<std::uint64_t>(stage));
    if (!own) return unknown("this code renders whole frames only, no part of one");
    Verification result;
    result.agreement = agreementOf(cutOut(picture, windows).view(), own->view(), !scene.isForT1);
    result.kind =
        result.agreement.agrees ? Verification::Kind::same : Verification::Kind::different;
    result.own = OwnWindows{windows, *std::move(own), !scene.isForT1};
    return result;
}

// Code that draws one pattern of points for all pixels has pictures that differ as wholes.
bool agreesWithItself(const Scene& scene, const OwnWindows& own, std::uint64_t seed) {
    const std::optional<Picture> again = renderWindows(scene, own.windows, seed);
    return again && agreementOf(again->view(), own.pixels.view(), own.isRandom).agrees;
}

}  // namespace

Verification verify(const ByteView& picture, const Scene& scene, std::uint64_t seed) {
    if (scene.examinee == nullptr) return unknown("");
    Verification first = compareOnce(picture, scene, seed, 0);
    if (first.kind != Verification::Kind::different || scene.isForT1) return first;
    Verification second = compareOnce(picture, scene, seed, 1);
    if (second.kind == Verification::Kind::same) second.own = std::move(first.own);
    if (second.kind == Verification::Kind::different &&
        !agreesWithItself(scene, *second.own, seed + 2))
        return unknown("this code's own pictures differ as much from one to the next");
    return second;
}

}  // namespace ticker::decision::screenshot

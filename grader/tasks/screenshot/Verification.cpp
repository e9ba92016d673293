#include <grader/tasks/screenshot/Verification.h>

#include <grader/tasks/screenshot/Windows.h>

#include <utility>

namespace ticker::tasks::screenshot {
namespace {

Verification unknown(const char* why) {
    return {Verification::Kind::unknown, why, {}, {}};
}

Verification unanswered(const probe::ProcessEnd& end) {
    switch (end.kind) {
        case probe::ProcessEnd::Kind::ourFault:
            return {Verification::Kind::ourFault, end.detail, {}, {}};
        case probe::ProcessEnd::Kind::finished:
            return unknown("this code renders whole frames only, no part of one");
        default:
            return unknown("this code did not finish when it was asked for parts of the frame");
    }
}

Verification compareOnce(const ByteView& picture, const Scene& scene, std::uint64_t seed,
                         int stage) {
    const Windows windows =
        drawWindows(!scene.isRandom, picture.width, picture.height, seed, stage);
    OwnRender own = askForWindows(scene, windows, seed + static_cast<std::uint64_t>(stage));
    if (!own.windows) return unanswered(own.end);
    Verification result;
    result.agreement =
        agreementOf(cutOut(picture, windows).view(), own.windows->view(), scene.isRandom);
    result.kind =
        result.agreement.agrees ? Verification::Kind::same : Verification::Kind::different;
    result.own = OwnWindows{windows, *std::move(own.windows), scene.isRandom};
    return result;
}

}  // namespace

Verification verify(const ByteView& picture, const Scene& scene, std::uint64_t seed) {
    if (scene.examinee == nullptr) return unknown("");
    Verification first = compareOnce(picture, scene, seed, 0);
    if (first.kind != Verification::Kind::different || !scene.isRandom) return first;
    Verification second = compareOnce(picture, scene, seed, 1);
    if (second.kind == Verification::Kind::same) second.own = std::move(first.own);
    return second;
}

}  // namespace ticker::tasks::screenshot

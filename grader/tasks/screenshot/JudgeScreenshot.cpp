#include <grader/tasks/screenshot/JudgeScreenshot.h>

#include <grader/tasks/screenshot/Edits.h>
#include <grader/tasks/screenshot/Relief.h>
#include <grader/tasks/screenshot/Repetition.h>
#include <grader/tasks/screenshot/ScreenshotWords.h>
#include <grader/tasks/screenshot/SeenMistake.h>
#include <grader/tasks/screenshot/Verification.h>
#include <grader/tasks/screenshot/Whole.h>
#include <grader/tasks/screenshot/WindowDoubt.h>
#include <grader/tasks/screenshot/Windows.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using namespace screenshot;

// Noise of two renders, and edges between pixels: the largest value of 120 honest pictures was 4.0
// (option 1) and 2.3 (option 2).
constexpr double kMostTileDifference = 10.0;
// The noise of more than a thousand rays, where the handout says fifty.
constexpr double kNoNoise = 1.0 / 25.0;

TaskJudgement passed(std::vector<Finding> notes) {
    return {TaskState::passed, "", std::move(notes), false};
}

TaskJudgement notChecked(const char* why) {
    return {TaskState::blocked, std::string{kNotChecked} + why, {}, false};
}

TaskJudgement passedInDoubt(Finding doubt) {
    return {TaskState::passed, "", {std::move(doubt)}, true};
}

TaskJudgement failed(Finding finding) {
    return {TaskState::failed, "", {std::move(finding)}, false};
}

/// Compares a picture with the scene that it resembles most.
class Judge {
public:
    Judge(const ByteView& picture, const std::vector<Scene>& scenes, std::uint64_t seed)
        : picture_(picture), scenes_(scenes), scene_(nearestWanted()), seed_(seed) {}

    [[nodiscard]] TaskJudgement judge() const {
        if (!isSensibleSize(picture_.width, picture_.height)) return judgeOtherSize();
        const Verification verification = verify(picture_, scene_, seed_);
        if (verification.kind == Verification::Kind::ourFault) return withoutWindows(verification);
        const TileDifference whole = tileDifference(scene_.likeliest(), picture_);
        const bool looksRight = scene_.hasOwn()
                                    ? whole.worst <= kMostTileDifference
                                    : likeness(scene_.expected(), picture_) >= kSameScene;
        if (verification.kind != Verification::Kind::different && looksRight)
            return accept(verification);
        const std::optional<Verification> doubt =
            scene_.whyUnlikeItself.empty() ? doubtOf(verification) : std::nullopt;
        if (doubt && (looksRight || doubt->kind == Verification::Kind::ourFault))
            return withoutWindows(*doubt);
        const std::string why = whyNotRepeated(scene_, picture_.width, picture_.height, seed_ + 2);
        return why.empty() ? explain(doubt ? *doubt : verification, whole) : excuse(why);
    }

private:
    /// Why the windows may not count against the picture; empty if they may, or without windows.
    [[nodiscard]] std::optional<Verification> doubtOf(const Verification& verification) const {
        return verification.own ? doubtOfWindows(scene_, seed_ + 3) : std::nullopt;
    }

    /// The judgement of a picture that looks right from far away.
    [[nodiscard]] TaskJudgement withoutWindows(const Verification& verification) const {
        if (verification.kind == Verification::Kind::ourFault)
            return {TaskState::notGraded, verification.why, {}, false};
        return verification.why.empty()
                   ? notChecked("there is no code that runs to compare it with")
                   : passed({unverified(verification.why)});
    }

    [[nodiscard]] double likenessTo(const Scene& scene) const {
        const double expected = likeness(scene.expected(), picture_);
        return scene.hasOwn() ? std::max(expected, likeness(scene.own, picture_)) : expected;
    }

    [[nodiscard]] const Scene& nearestWanted() const {
        std::vector<const Scene*> wanted;
        for (const Scene& scene : scenes_)
            if (scene.isWanted) wanted.push_back(&scene);
        if (wanted.size() == 1) return *wanted.front();
        if (wanted.empty()) return scenes_.front();
        return **std::ranges::max_element(
            wanted, {}, [this](const Scene* scene) { return likenessTo(*scene); });
    }

    /// Another scene that the picture shows, and clearly not this one; null otherwise.
    [[nodiscard]] const Scene* otherScene() const {
        // Among similar scenes the handout's comes first and is the likelier one.
        constexpr double kClearlyMore = 0.04;
        const double here = likenessTo(scene_);
        const Scene* nearest = nullptr;
        double most = kSameScene;
        for (const Scene& scene : scenes_) {
            if (&scene == &scene_) continue;
            const double there = likenessTo(scene);
            if (there <= most || (here >= kSameScene && !isRatherThanThis(scene))) continue;
            nearest = &scene;
            most = there + kClearlyMore;
        }
        return nearest;
    }

    // Scenes that differ only in their bump map resemble each other: the code or the relief
    // decides.
    [[nodiscard]] bool isRatherThanThis(const Scene& scene) const {
        if (verify(picture_, scene, seed_).kind == Verification::Kind::same) return true;
        return !scene.isRandom && !scene_.isRandom && scene.hasOwn() && scene_.hasOwn() &&
               isRather(reliefOf(picture_, scene), reliefOf(picture_, scene_));
    }

    [[nodiscard]] TaskJudgement judgeOtherSize() const {
        const std::optional<Cut> cut = findCut(picture_, scene_);
        if (cut && cut->kind != Cut::Kind::otherShape) return failed(cutPicture(picture_, *cut));
        return failed(wrongSize(picture_, cut));
    }

    [[nodiscard]] TaskJudgement accept(const Verification& verification) const {
        if (!verification.own) return withoutWindows(verification);
        if (verification.agreement.isLossy) {
            std::optional<TaskJudgement> slight = judgeSlightColours(verification);
            return slight ? *std::move(slight) : passed({savedAgain(verification.agreement)});
        }
        if (!scene_.isRandom) return passed({});
        const Picture windows = cutOut(picture_, verification.own->windows);
        const std::optional<double> noise =
            noiseRatio(windows.view(), verification.own->pixels.view());
        if (!noise || *noise >= kNoNoise) return passed({});
        const std::optional<Verification> doubt = doubtOf(verification);
        return doubt ? withoutWindows(*doubt) : passedInDoubt(isTheReference(*noise));
    }

    // The judgement of code whose renders differ: it may have drawn any picture that shows the
    // scene.
    // @param why  The reason why they differ.
    [[nodiscard]] TaskJudgement excuse(const std::string& why) const {
        if (const Scene* other = otherScene())
            return failed(notThisScene(scene_.name, other->name));
        if (likenessTo(scene_) < kSameScene) return failed(notThisScene(scene_.name, ""));
        return passed({unverified(why)});
    }

    [[nodiscard]] TaskJudgement explain(const Verification& verification,
                                        const TileDifference& whole) const {
        const OwnWindows* own = verification.own ? &*verification.own : nullptr;
        const bool windowsAgree = verification.kind == Verification::Kind::same;
        if (std::optional<Finding> edit = findEdit(windowsAgree ? nullptr : own))
            return failed(*std::move(edit));
        if (isPaintedOver(verification, whole)) return failed(paintedOver(whole));
        if (own != nullptr)
            if (std::optional<TaskJudgement> slight = judgeSlightColours(verification))
                return *slight;
        if (const Scene* other = otherScene())
            return failed(notThisScene(scene_.name, other->name));
        if (likenessTo(scene_) < kSameScene) return failed(notThisScene(scene_.name, ""));
        if (scene_.mayMixBoth)
            return passed({unverified("it may have been rendered with both of the files")});
        if (!scene_.isRandom && scene_.hasOwn() && isSofter(reliefOf(picture_, scene_)))
            return passedInDoubt(perhapsThroughTheLens());
        if (own == nullptr) return passedInDoubt(perhapsNotFromThisCode(picture_, scene_, whole));
        return judgeStranger(verification, whole);
    }

    // Saving as JPEG, scaling or cutting a row off changes every pixel, but not what the picture
    // shows; a mouse pointer covers little.
    [[nodiscard]] TaskJudgement judgeStranger(const Verification& verification,
                                              const TileDifference& whole) const {
        constexpr int kSmallThing = 4;  // tiles
        const TaskJudgement doubt = passedInDoubt(likeThisCode(scene_));
        const bool windowsAgree = verification.kind == Verification::Kind::same;
        const bool isSameRelief =
            !scene_.isRandom && scene_.hasOwn() && isSame(reliefOf(picture_, scene_));
        if (isSameRelief && !windowsAgree) return doubt;
        const OwnWindows& own = *verification.own;
        const Picture windows = cutOut(picture_, own.windows);
        const std::optional<SeenMistake> mistake =
            seenMistake(windows.view(), scene_, own.windows, seed_);
        if (windowsAgree && (!mistake || mistake->id.empty()))
            return whole.tilesOff <= kSmallThing ? failed(paintedOver(whole)) : doubt;
        if (scene_.isRandom && !mistake && looksRightInOtherColours()) return doubt;
        return failed(notFromThisCode(picture_, scene_, verification.agreement, mistake));
    }

    [[nodiscard]] bool looksRightInOtherColours() const {
        const ByteView reference = scene_.likeliest();
        const Picture changed = ColourChange{reference, picture_}.appliedTo(reference);
        return tileDifference(changed.view(), picture_).worst <= kMostTileDifference;
    }

    [[nodiscard]] std::optional<Finding> findEdit(const OwnWindows* own) const {
        if (own != nullptr)
            if (const auto shift = findShift(picture_, *own)) return moved(*shift);
        if (const auto mirror = findMirror(picture_, scene_, own)) return mirroredPicture(*mirror);
        if (const auto change = findRecolouring(picture_, scene_); change && !change->isSlight())
            return recoloured(*change);
        if (const auto cut = findCut(picture_, scene_); cut && cut->kind != Cut::Kind::otherShape)
            return cutPicture(picture_, *cut);
        return std::nullopt;
    }

    // Other code differs a little in most windows; a pasted note differs much and covers one or
    // two.
    [[nodiscard]] bool isPaintedOver(const Verification& verification,
                                     const TileDifference& whole) const {
        constexpr int kMostCovered = 2;
        constexpr double kAnotherColour = 30.0;  // steps of a byte
        if (whole.worst < kAnotherColour || !verification.own) return false;
        if (verification.kind == Verification::Kind::same) return true;
        const int count = static_cast<int>(verification.own->windows.boxes.size());
        return count > 2 * kMostCovered &&
               count - agreeingWindows(picture_, *verification.own) <= kMostCovered;
    }

    // "Colours may differ slightly": the windows must agree once the colours are corrected.
    [[nodiscard]] std::optional<TaskJudgement> judgeSlightColours(
        const Verification& verification) const {
        const std::optional<Recolouring> change = findRecolouring(picture_, scene_);
        if (!change) return std::nullopt;
        const OwnWindows& own = *verification.own;
        const Picture changed =
            ColourChange{scene_.likeliest(), picture_}.appliedTo(own.pixels.view());
        const Picture windows = cutOut(picture_, own.windows);
        const Agreement after = agreementOf(windows.view(), changed.view(), own.isRandom);
        const bool isBetter = own.isRandom || after.rms < 0.5 * verification.agreement.rms;
        if (!after.agrees || !isBetter) return std::nullopt;
        return passed({slightlyOtherColours(*change)});
    }

    const ByteView& picture_;
    const std::vector<Scene>& scenes_;
    const Scene& scene_;
    std::uint64_t seed_;
};

}  // namespace

TaskJudgement judgeScreenshot(const metrics::ByteView& picture,
                              const std::vector<screenshot::Scene>& scenes, std::uint64_t seed) {
    if (scenes.empty())
        return isSensibleSize(picture.width, picture.height)
                   ? notChecked("there is no scene to compare it with")
                   : failed(wrongSize(picture, std::nullopt));
    return Judge{picture, scenes, seed}.judge();
}

}  // namespace ticker::tasks

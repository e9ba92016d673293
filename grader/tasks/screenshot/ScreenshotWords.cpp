#include <grader/probe/Question.h>
#include <grader/tasks/screenshot/DifferenceRaster.h>
#include <grader/tasks/screenshot/ScreenshotFindings.h>
#include <grader/tasks/screenshot/ScreenshotWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

Finding finding(const FindingText& text, Severity severity, std::string message, std::string hint) {
    Finding result;
    result.id = text.id;
    result.severity = severity;
    result.message = std::move(message);
    result.hint = std::move(hint);
    result.section = "Test and submit";
    return result;
}

Finding edited(std::string what, const std::string& message) {
    Finding result = finding(kScreenshotEdited, Severity::fail, message,
                             "Hand in the file that tick1star -o screenshot.png writes, as it is.");
    result.evidence.emplace_back("edit", std::move(what));
    return result;
}

std::string sceneFile(const std::string& name) {
    return "scenes/" + name + ".xml";
}

void addSize(Finding& finding, const ByteView& picture) {
    finding.evidence.emplace_back("width", static_cast<double>(picture.width));
    finding.evidence.emplace_back("height", static_cast<double>(picture.height));
}

Finding otherCode(const ByteView& picture, const Scene& scene, Severity severity,
                  const std::string& told) {
    Finding result = finding(
        kScreenshotNotFromThisCode, severity,
        fmt::format("The picture shows {}, but not as this {} renders it{}", scene.name, scene.file,
                    told),
        fmt::format(
            "Render {} once more with the code that you hand in, at the handout's settings, "
            "and hand in both together.",
            sceneFile(scene.name)));
    result.rasters.push_back(differenceOf(scene.likeliest(), picture));
    return result;
}

}  // namespace

Finding wrongSize(const ByteView& picture, const std::optional<Cut>& cut) {
    const bool isOtherShape = cut && cut->kind == Cut::Kind::otherShape;
    Finding result = finding(
        kScreenshotWrongSize, Severity::fail,
        fmt::format("The picture has {} x {} pixels{}; expected is the handout's shape, 4 : 3, "
                    "with {} x {} "
                    "to {} x {} pixels.",
                    picture.width, picture.height,
                    isOtherShape ? ", so it shows more or less of the scene above and below" : "",
                    kSmallestWidth, kSmallestWidth * 3 / 4, probe::kLargestFrame,
                    probe::kLargestFrame * 3 / 4),
        "Render the scene at tick1star's own size, 640 x 480, and hand in that file, not a picture "
        "of the screen.");
    addSize(result, picture);
    return result;
}

Finding notThisScene(const std::string& wanted, const std::string& shown) {
    Finding result =
        finding(kScreenshotNotThisScene, Severity::fail,
                shown.empty()
                    ? fmt::format("The picture does not show {}, the scene of this option.", wanted)
                    : fmt::format("The picture shows {}; expected is {}, the scene of this option.",
                                  shown, wanted),
                fmt::format("Render {} with tick1star -i {} -o screenshot.png{}.", wanted,
                            sceneFile(wanted), wanted == "bump-mapping" ? " --pinhole" : ""));
    if (!shown.empty()) result.evidence.emplace_back("shown", shown);
    return result;
}

Finding moved(Shift shift) {
    const auto pixels = [](int count, const char* less, const char* more) {
        return count == 0 ? ""
                          : fmt::format(" {} pixel{} {}", std::abs(count),
                                        std::abs(count) == 1 ? "" : "s", count < 0 ? less : more);
    };
    const bool isOriginal = shift.right == 0 && shift.down == 1;
    Finding result =
        edited("moved", fmt::format("The picture is moved{}{} against what this code renders.{}",
                                    pixels(shift.right, "to the left", "to the right"),
                                    pixels(shift.down, "up", "down"),
                                    isOriginal ? " The course's old Java kit renders so." : ""));
    result.evidence.emplace_back("right", static_cast<double>(shift.right));
    result.evidence.emplace_back("down", static_cast<double>(shift.down));
    return result;
}

Finding mirroredPicture(metrics::Mirror mirror) {
    switch (mirror) {
        case metrics::Mirror::leftRight:
            return edited("mirrored left to right", "The picture is mirrored left to right.");
        case metrics::Mirror::upDown:
            return edited("mirrored upside down", "The picture is mirrored upside down.");
        case metrics::Mirror::both:
            return edited("turned", "The picture is turned by half a turn.");
    }
    return {};
}

Finding recoloured(const Recolouring& change) {
    Finding result = edited(
        "recoloured",
        fmt::format("The picture is the scene's, but {}: it is off by {:.0f} of 255 on average; up "
                    "to {:.0f} are taken as a slight difference.",
                    change.words, change.distance, Recolouring::kSlight));
    result.evidence.emplace_back("colourDistance", change.distance);
    return result;
}

Finding cutPicture(const ByteView& picture, const Cut& cut) {
    const bool isFramed = cut.kind == Cut::Kind::framed;
    Finding result =
        isFramed ? edited("framed",
                          fmt::format("The scene is only a part of the picture, {:.0f} % of it: it "
                                      "looks like a picture of the screen or of a window.",
                                      100.0 * cut.share))
                 : edited("cropped", fmt::format("The picture shows only a part of the scene, "
                                                 "{:.0f} % of it.",
                                                 100.0 * cut.share));
    addSize(result, picture);
    result.evidence.emplace_back("correlation", cut.fit.correlation);
    return result;
}

Finding paintedOver(const TileDifference& difference) {
    const auto third = [](double share, const char* low, const char* middle, const char* high) {
        return share < 1.0 / 3.0 ? low : share > 2.0 / 3.0 ? high : middle;
    };
    Finding result = edited(
        "changed in one place",
        fmt::format("Parts of the picture are what this code renders, but something else stands {} "
                    "{}.",
                    third(difference.worstY, "above", "half-way down", "below"),
                    third(difference.worstX, "on the left", "in the middle", "on the right")));
    result.evidence.emplace_back("tileDifference", difference.worst);
    result.evidence.emplace_back("place",
                                 std::vector<double>{difference.worstX, difference.worstY});
    return result;
}

Finding notFromThisCode(const ByteView& picture, const Scene& scene, const Agreement& agreement,
                        const std::optional<SeenMistake>& mistake) {
    std::string told = ": it was made by other code, or with other settings.";
    if (mistake && mistake->id.empty())
        told = ": it is right, but of another reading, made by other code or with other settings.";
    if (mistake && !mistake->id.empty())
        told = fmt::format(": it shows {}, which this code does not.", mistake->words);
    Finding result = otherCode(picture, scene, Severity::fail, told);
    if (mistake && !mistake->id.empty()) result.evidence.emplace_back("looksLike", mistake->id);
    if (!scene.isRandom) {
        result.evidence.emplace_back("differingShare", agreement.differing);
    } else {
        result.evidence.emplace_back("energy", agreement.energy.energy);
        result.evidence.emplace_back("tiles", static_cast<double>(agreement.energy.tiles));
        result.evidence.emplace_back("chanceAtMost", agreement.energy.probability());
    }
    result.evidence.emplace_back("rms", agreement.rms);
    return result;
}

Finding perhapsNotFromThisCode(const ByteView& picture, const Scene& scene,
                               const TileDifference& difference) {
    Finding result =
        otherCode(picture, scene, Severity::warn,
                  ", as far as can be told: no part of it could be compared pixel by pixel.");
    result.evidence.emplace_back("tileDifference", difference.worst);
    return result;
}

Finding likeThisCode(const Scene& scene) {
    return finding(kScreenshotUnverified, Severity::warn,
                   fmt::format("The picture looks like what this {} renders, but pixel by pixel it "
                               "differs: it may have been scaled, cut, saved as JPEG or with fewer "
                               "colours, or rendered by an earlier version.",
                               scene.file),
                   "Hand in the file that tick1star -o screenshot.png writes, as it is.");
}

Finding perhapsThroughTheLens() {
    return finding(kScreenshotUnverified, Severity::warn,
                   "The picture is softer than this BumpySphere.cpp makes it with the template's "
                   "Renderer.cpp: it may have been rendered with a solved Renderer.cpp, which was "
                   "not handed in.",
                   "Hand in the Renderer.cpp as well, or render scenes/bump-mapping.xml with the "
                   "template's.");
}

Finding isTheReference(double ratio) {
    Finding result = finding(
        kScreenshotIsTheReference, Severity::warn,
        fmt::format("The picture has {:.1f} % of the noise that this code leaves: it is the "
                    "course's reference picture, or took more than a thousand rays for each pixel.",
                    100.0 * ratio),
        "Hand in what your code renders at the handout's settings: noise is no fault.");
    result.evidence.emplace_back("noiseRatio", ratio);
    return result;
}

Finding slightlyOtherColours(const Recolouring& change) {
    Finding result = finding(kScreenshotColours, Severity::note,
                             fmt::format("The colours differ slightly from what this code renders, "
                                         "by {:.1f} of 255 on average.",
                                         change.distance),
                             "");
    result.evidence.emplace_back("colourDistance", change.distance);
    return result;
}

Finding savedAgain(const Agreement& agreement) {
    Finding result =
        finding(kScreenshotResaved, Severity::note,
                "The picture has small errors everywhere, as those of a JPEG file that "
                "was saved as PNG.",
                "Hand in the file that tick1star -o screenshot.png writes, as it is.");
    result.evidence.emplace_back("rms", agreement.rms);
    return result;
}

Finding unverified(const std::string& why) {
    return finding(kScreenshotUnverified, Severity::note,
                   "The picture was compared with the scene from far away only: " + why + ".", "");
}

}  // namespace ticker::tasks::screenshot

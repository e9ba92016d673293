#include <grader/tasks/screenshot/WindowDoubt.h>

#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Windows.h>

#include <raytracer/image/ToneCurve.h>

#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

constexpr int kFrameWidth = 160;
constexpr int kFrameHeight = 120;

using Colours = std::vector<raytracer::ColourRGB>;

/// Linear colours of the frame's parts, one below the other; empty if some are missing.
struct Strip {
    Colours colours;
    probe::ProcessEnd end;
};

// Regions of unequal height: a frame that is turned or mirrored moves each to another place.
Windows fourParts() {
    return {kFrameWidth,
            kFrameHeight,
            {{0, 0, 80, 48}, {80, 0, 80, 48}, {0, 48, 80, 72}, {80, 48, 80, 72}}};
}

Colours cutStrip(const Colours& frame) {
    Colours strip;
    for (const metrics::Box& box : fourParts().boxes)
        for (int y = box.y; y < box.y + box.height; ++y) {
            const auto row = frame.begin() + y * kFrameWidth + box.x;
            strip.insert(strip.end(), row, row + box.width);
        }
    return strip;
}

/// Compares renders of the small frame. Each has a process of its own, as the student's picture and
/// the windows have.
class SmallFrame {
public:
    SmallFrame(const Scene& scene, std::uint64_t seed, bool isOneRay)
        : scene_(scene), seed_(seed), isOneRay_(isOneRay) {}

    [[nodiscard]] Strip inParts() const { return ask(fourParts()); }

    [[nodiscard]] Strip whole() const {
        Strip frame = ask({kFrameWidth, kFrameHeight, {{0, 0, 0, 0}}});
        if (!frame.colours.empty()) frame.colours = cutStrip(frame.colours);
        return frame;
    }

    /// Equal to the last bit, or with several rays for each pixel equal within noise: one ray does
    /// not show how large the noise is.
    [[nodiscard]] bool areAlike(const Strip& first, const Strip& second) const {
        if (first.colours == second.colours) return true;
        return !isOneRay_ && areAlikeInBytes(bytesOf(first).view(), bytesOf(second).view());
    }

private:
    [[nodiscard]] Strip ask(const Windows& windows) const {
        std::vector<probe::Question> questions = questionsFor(scene_, windows, seed_);
        for (probe::Question& question : questions) {
            auto& settings = std::get<probe::RenderQuestion>(question).settings;
            if (isOneRay_) settings.dofRayCount = settings.shadowRayCount = 1;
        }
        const probe::Run run = scene_.examinee->ask(questions);
        Strip strip{{}, run.end};
        for (const probe::Answer& any : run.answers) {
            const auto* answer = std::get_if<probe::RenderAnswer>(&any);
            if (answer == nullptr || !isWhole(*answer)) return {{}, run.end};
            const Colours& image = answer->images.front();
            strip.colours.insert(strip.colours.end(), image.begin(), image.end());
        }
        return strip;
    }

    // A whole frame may get more rays than a part of it. That shows in the noise alone, so that it
    // is compared, too.
    [[nodiscard]] bool areAlikeInBytes(const ByteView& first, const ByteView& second) const {
        constexpr double kOtherRays = 4.0;
        if (!agreementOf(first, second, scene_.isRandom).agrees) return false;
        if (!scene_.isRandom) return true;
        const std::optional<double> ratio = noiseRatio(first, second);
        return !ratio || (*ratio > 1.0 / kOtherRays && *ratio < kOtherRays);
    }

    static Picture bytesOf(const Strip& strip) {
        const int width = fourParts().boxes.front().width;
        Picture picture{width, static_cast<int>(strip.colours.size()) / width, {}};
        for (const raytracer::ColourRGB& colour : strip.colours)
            for (const std::uint8_t byte : raytracer::toneMapped(colour))
                picture.rgb.push_back(byte);
        return picture;
    }

    const Scene& scene_;
    std::uint64_t seed_;
    bool isOneRay_;
};

Verification without(const probe::ProcessEnd& end, const char* why) {
    if (end.kind == probe::ProcessEnd::Kind::ourFault)
        return {Verification::Kind::ourFault, end.detail, {}, {}};
    return {Verification::Kind::unknown, why, {}, {}};
}

}  // namespace

std::optional<Verification> doubtOfWindows(const Scene& scene, std::uint64_t seed) {
    for (const bool isOneRay : {true, false}) {
        const SmallFrame frame{scene, seed, isOneRay};
        const Strip whole = frame.whole();
        const Strip parts = frame.inParts();
        for (const Strip* strip : {&whole, &parts})
            if (strip->colours.empty())
                return without(strip->end, "this code did not render a small frame for comparison");
        if (frame.areAlike(whole, parts)) return std::nullopt;
        // If whole frames differ from each other as well, the code does not repeat itself, and
        // the comparison shows nothing about parts.
        if (!isOneRay && !frame.areAlike(whole, frame.whole())) return std::nullopt;
    }
    return without({},
                   "this code renders a part of a frame (--region) otherwise than the same place "
                   "of the whole frame");
}

}  // namespace ticker::tasks::screenshot

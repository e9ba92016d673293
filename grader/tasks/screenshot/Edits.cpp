#include <grader/tasks/screenshot/Edits.h>

#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Whole.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

bool agrees(const ByteView& picture, const OwnWindows& own, Shift shift = {}) {
    const Picture windows = cutOut(picture, own.windows, shift.right, shift.down);
    return agreementOf(windows.view(), own.pixels.view(), own.isRandom).agrees;
}

std::vector<Shift> shiftsByLength() {
    std::vector<Shift> shifts;
    for (int down = -kFarthestShift; down <= kFarthestShift; ++down)
        for (int right = -kFarthestShift; right <= kFarthestShift; ++right)
            if (right != 0 || down != 0) shifts.push_back({right, down});
    std::ranges::stable_sort(shifts, {}, [](const Shift& shift) {
        return shift.right * shift.right + shift.down * shift.down;
    });
    return shifts;
}

bool isGrey(const Picture& picture) {
    constexpr int kHardly = 3;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        const auto [least, most] =
            std::minmax({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
        if (most - least > kHardly) return false;
    }
    return true;
}

Picture withRedForBlue(const ByteView& picture) {
    Picture result{picture.width, picture.height, {picture.rgb.begin(), picture.rgb.end()}};
    for (std::size_t i = 0; i < result.rgb.size(); i += 3)
        std::swap(result.rgb[i], result.rgb[i + 2]);
    return result;
}

std::string wordsFor(const ByteView& reference, const Picture& picture, double distance) {
    if (likeness(reference, picture.view()) < 0.0) return "it is a negative";
    if (isGrey(picture)) return "it has no colours";
    if (tileDifference(withRedForBlue(reference).view(), picture.view()).rms < 0.25 * distance)
        return "red and blue are exchanged";
    return "its colours or its brightness were changed";
}

std::vector<int> widthsBelow(int most, double least) {
    constexpr double kStep = 1.03;
    std::vector<int> widths;
    for (double width = most; width >= least * most; width /= kStep) {
        const int whole = static_cast<int>(std::lround(width));
        if (widths.empty() || widths.back() != whole) widths.push_back(whole);
    }
    return widths;
}

Picture ofWidth(const ByteView& picture, int width) {
    const int height = static_cast<int>(std::lround(1.0 * width * picture.height / picture.width));
    return metrics::resized(picture, width, std::max(1, height));
}

// Whether the inner picture is as wide as the outer one, and in its middle. Then nothing was cut
// off or added; the camera saw more or less above and below.
bool isOtherShape(const metrics::Fit& fit, int width, int height) {
    const int above = fit.box.y;
    const int below = height - fit.box.y - fit.box.height;
    return fit.box.width >= 0.97 * width && std::abs(above - below) <= 4 && above + below > 4;
}

Cut cutOf(Cut::Kind kind, const metrics::Fit& fit, const Picture& outer) {
    Cut cut{kind, fit, 0.0};
    cut.share = 1.0 * fit.box.width * fit.box.height / (1.0 * outer.width * outer.height);
    if (isOtherShape(fit, outer.width, outer.height)) cut.kind = Cut::Kind::otherShape;
    return cut;
}

}  // namespace

int agreeingWindows(const ByteView& picture, const OwnWindows& own) {
    const Picture windows = cutOut(picture, own.windows);
    int agreeing = 0;
    int top = 0;
    for (const metrics::Box& box : own.windows.boxes) {
        const metrics::Box part{0, top, box.width, box.height};
        const Picture seen = metrics::cropped(windows.view(), part);
        const Picture rendered = metrics::cropped(own.pixels.view(), part);
        agreeing += agreementOf(seen.view(), rendered.view(), own.isRandom).agrees ? 1 : 0;
        top += box.height;
    }
    return agreeing;
}

std::optional<Shift> findShift(const ByteView& picture, const OwnWindows& own) {
    for (const Shift& shift : shiftsByLength())
        if (agrees(picture, own, shift)) return shift;
    return std::nullopt;
}

std::optional<metrics::Mirror> findMirror(const ByteView& picture, const Scene& scene,
                                          const OwnWindows* own) {
    // Under another reading of the bump map a picture is less like the scene, mirrored or not; the
    // lights decide.
    constexpr double kLikeEnough = 0.93;
    constexpr double kClearlyMore = 0.02;
    const double unmirrored = likeness(scene.likeliest(), picture);
    for (const metrics::Mirror mirror :
         {metrics::Mirror::leftRight, metrics::Mirror::upDown, metrics::Mirror::both}) {
        const Picture candidate = metrics::mirrored(picture, mirror);
        if (own != nullptr && agrees(candidate.view(), *own)) return mirror;
        const double mirrored = likeness(scene.likeliest(), candidate.view());
        if (mirrored >= kLikeEnough && mirrored >= unmirrored + kClearlyMore) return mirror;
    }
    return std::nullopt;
}

std::optional<Recolouring> findRecolouring(const ByteView& picture, const Scene& scene) {
    constexpr double kExplained = 0.25;  // share of the distance that may remain
    constexpr double kLikeEnough = 0.97;
    const ByteView reference = scene.likeliest();
    const double distance = tileDifference(reference, picture).rms;
    const Picture changed = ColourChange{reference, picture}.appliedTo(reference);
    const double left = tileDifference(changed.view(), picture).rms;
    if (left > kExplained * distance || likeness(changed.view(), picture) < kLikeEnough)
        return std::nullopt;
    const Picture small = metrics::resized(picture, kSmallWidth, kSmallHeight);
    return Recolouring{distance, wordsFor(reference, small, distance)};
}

std::optional<Cut> findCut(const ByteView& picture, const Scene& scene) {
    constexpr int kOuter = 240;  // pixels: enough for a window on a large screen
    constexpr double kLikeEnough = 0.95;
    constexpr double kMostShare = 0.96;  // a larger share is the picture itself
    // A strip of one pixel's width would be made as high as a few million.
    constexpr int kMostElongated = 8;
    if (std::max(picture.width, picture.height) >
        kMostElongated * std::min(picture.width, picture.height))
        return std::nullopt;
    const Picture outer = ofWidth(picture, kOuter);
    const Picture inner = ofWidth(scene.likeliest(), kSmallWidth);
    const metrics::Fit framed =
        metrics::bestFit(outer.view(), inner.view(), widthsBelow(kOuter, 0.25));
    const Picture whole = ofWidth(scene.likeliest(), kOuter);
    const metrics::Fit cropped = metrics::bestFit(
        whole.view(), ofWidth(picture, kSmallWidth).view(), widthsBelow(kOuter, 0.4));
    const bool isFramed = framed.correlation >= cropped.correlation;
    if (std::max(framed.correlation, cropped.correlation) < kLikeEnough) return std::nullopt;
    const Cut cut = isFramed ? cutOf(Cut::Kind::framed, framed, outer)
                             : cutOf(Cut::Kind::cropped, cropped, whole);
    if (cut.share > kMostShare) return std::nullopt;
    return cut;
}

}  // namespace ticker::tasks::screenshot

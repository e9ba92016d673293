#include <grader/tasks/screenshot/DifferenceRaster.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker::tasks::screenshot {

Raster differenceOf(const ByteView& reference, const ByteView& picture) {
    constexpr double kFull = 64.0;
    const Picture own = metrics::resized(reference, kSmallWidth, kSmallHeight);
    const Picture handedIn = metrics::resized(picture, kSmallWidth, kSmallHeight);
    Raster raster;
    raster.title = fmt::format(
        "screenshot.png against what this code renders: red where it is brighter, blue where it "
        "is darker, full at {:.0f} of 255",
        kFull);
    raster.width = kSmallWidth;
    raster.height = kSmallHeight;
    raster.colours = Raster::Colours::diverging;
    for (std::size_t i = 0; i < own.rgb.size(); i += 3) {
        double off = 0.0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            off += (handedIn.rgb[i + channel] - own.rgb[i + channel]) / 3.0;
        raster.values.push_back(static_cast<float>(std::clamp(off / kFull, -1.0, 1.0)));
    }
    return raster;
}

}  // namespace ticker::tasks::screenshot

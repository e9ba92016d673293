#include "Canvas.h"

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace raytracer {
namespace {

// Without observer: the copy must not report its own pixels.
RenderSettings unwatched(RenderSettings settings) {
    settings.observer = nullptr;
    settings.monitor = nullptr;
    return settings;
}

}  // namespace

Canvas::Canvas(const RenderSettings& settings, std::function<bool()> interrupted)
    : picture_(unwatched(settings)),
      bytes_{picture_.width(), picture_.height(), {}},
      interrupted_(std::move(interrupted)),
      pixelsToCome_((settings.threads + 1) * settings.imageWidth()) {
    bytes_.rgb.resize(picture_.pixels().size() * 3);
}

Image Canvas::picture() const {
    const std::lock_guard lock{mutex_};
    return picture_;
}

ByteImage Canvas::bytes() const {
    const std::lock_guard lock{mutex_};
    return bytes_;
}

void Canvas::pixelSet(int x, int y, const ColourRGB& colour) {
    const std::array<std::uint8_t, 3> bytes = toneMapped(colour);
    const std::lock_guard lock{mutex_};
    picture_.set(x, y, colour);
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(bytes_.width) +
                              static_cast<std::size_t>(x);
    std::copy(bytes.begin(), bytes.end(),
              bytes_.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
    if (interrupted_() && --pixelsToCome_ < 0) throw RenderStopped();
}

}  // namespace raytracer

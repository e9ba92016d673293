#include "NormalPicture.h"

#include <raytracer/image/Image.h>
#include <raytracer/render/ForEachPixel.h>
#include <raytracer/scene/Camera.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raytracer {
namespace {

std::uint8_t byteOf(double component) {
    if (!std::isfinite(component)) return 0;
    return static_cast<std::uint8_t>(std::clamp(127.5 + 127.5 * component + 0.5, 0.0, 255.0));
}

}  // namespace

ByteImage normalPicture(const Scene& scene, const RenderSettings& settings) {
    const Camera camera{settings};
    const Image frame{settings};
    ByteImage picture{frame.width(), frame.height(), {}};
    picture.rgb.resize(frame.pixels().size() * 3);
    forEachPixel(frame, [&](int x, int y) {
        const std::optional<RaycastHit> hit = scene.findClosestIntersection(camera.castRay(x, y));
        if (!hit) return;
        const std::size_t at =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width()) +
                 static_cast<std::size_t>(x));
        picture.rgb[at] = byteOf(hit->normal.x);
        picture.rgb[at + 1] = byteOf(hit->normal.y);
        picture.rgb[at + 2] = byteOf(-hit->normal.z);
    });
    return picture;
}

}  // namespace raytracer

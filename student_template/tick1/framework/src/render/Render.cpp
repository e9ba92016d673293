#include <raytracer/render/Renderer.h>

namespace raytracer {

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        image.set(x, y, trace(scene, camera.castRay(x, y), settings().bounces));
    });
    return image;
}

}  // namespace raytracer

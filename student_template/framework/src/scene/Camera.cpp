#include <raytracer/base/RenderObserver.h>
#include <raytracer/scene/Camera.h>

#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

constexpr double kHorizontalFieldOfView = std::numbers::pi / 4.0;

}  // namespace

Camera::Camera(const RenderSettings& settings)
    : settings_(settings), pitch_(2.0 * std::tan(kHorizontalFieldOfView / 2.0) / settings.width) {}

Ray Camera::castRay(int x, int y) const {
    const int offsetX = settings_.region.isWholeFrame() ? 0 : settings_.region.x;
    const int offsetY = settings_.region.isWholeFrame() ? 0 : settings_.region.y;
    const Vector3 towards{(x + offsetX + 0.5 - settings_.width / 2.0) * pitch_,
                          (settings_.height / 2.0 - y - offsetY - 0.5) * pitch_, 1.0};
    const Ray ray{{}, towards.normalised()};
    if (settings_.observer != nullptr) settings_.observer->cameraRayAsked(x, y, ray);
    return ray;
}

}  // namespace raytracer

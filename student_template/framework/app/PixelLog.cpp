#include "PixelLog.h"

#include <utility>

namespace raytracer {

void PixelLog::cameraRayAsked(int /*x*/, int /*y*/, const Ray& ray) {
    cameraRay_ = ray;
}

void PixelLog::traceBegan(const Ray& ray, int bouncesLeft) {
    OpenCall call;
    call.traced.ray = ray;
    call.traced.bouncesLeft = bouncesLeft;
    open_.push_back(std::move(call));
}

void PixelLog::traceEnded(const ColourRGB& colour) {
    if (open_.empty()) return;
    TracedRay finished = std::move(open_.back().traced);
    open_.pop_back();
    finished.colour = colour;
    (open_.empty() ? traced_ : open_.back().traced.reflected).push_back(std::move(finished));
}

void PixelLog::illuminateBegan(const SceneObject& /*object*/, const Vector3& /*position*/,
                               const Vector3& /*normal*/, const Vector3& /*viewer*/) {
    if (!open_.empty()) open_.back().illuminates = true;
}

void PixelLog::illuminateEnded(const ColourRGB& colour) {
    if (open_.empty()) return;
    open_.back().illuminates = false;
    open_.back().traced.direct = colour;
}

void PixelLog::rayCast(const Ray& ray, const RaycastHit* hit) {
    const std::optional<RaycastHit> met =
        hit == nullptr ? std::nullopt : std::optional<RaycastHit>(*hit);
    if (!open_.empty() && !open_.back().hasCast) {
        open_.back().hasCast = true;
        open_.back().traced.hit = met;
    } else if (!open_.empty() && open_.back().illuminates) {
        open_.back().traced.shadowRays.push_back({ray, met});
    } else {
        loose_.push_back({ray, met});
    }
}

void PixelLog::pixelSet(int /*x*/, int /*y*/, const ColourRGB& colour) {
    pixel_ = colour;
}

}  // namespace raytracer

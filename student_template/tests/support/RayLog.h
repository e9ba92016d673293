#ifndef SUPPORT_RAYLOG_H
#define SUPPORT_RAYLOG_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>

#include <mutex>
#include <vector>

namespace raytracer::tests {

/// No scene of the tests of T2.2 has anything before this z.
inline constexpr double kNearestSurface = 1.0;

/// Writes down the rays that a solution casts, whatever thread casts them.
class RayLog final : public RenderObserver {
public:
    /// Every ray of `Scene::findClosestIntersection`; directions have unit length.
    [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
    /// The most bounces that `trace` was asked for with a ray that starts where the camera is,
    /// before anything of a scene; -1 where there was none. Reflections of one's own have one less.
    [[nodiscard]] int mostBounces() const { return mostBounces_; }

    void clear() { rays_.clear(); }

    void cameraRayAsked(int, int, const Ray&) override {}
    void traceBegan(const Ray& ray, int bouncesLeft) override;
    void traceEnded(const ColourRGB&) override {}
    void illuminateBegan(const SceneObject&, const Vector3&, const Vector3&,
                         const Vector3&) override {}
    void illuminateEnded(const ColourRGB&) override {}
    void rayCast(const Ray& ray, const RaycastHit* hit) override;
    void pixelSet(int, int, const ColourRGB&) override {}

private:
    std::mutex mutex_;
    std::vector<Ray> rays_;
    int mostBounces_ = -1;
};

}  // namespace raytracer::tests

#endif

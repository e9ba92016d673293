#ifndef SUPPORT_RAYLOG_H
#define SUPPORT_RAYLOG_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>

#include <mutex>
#include <vector>

namespace raytracer::tests {

/// Scenes of the tests of T2.2 have no object before this z.
inline constexpr double kNearestSurface = 1.0;

/// Records the rays of a solution, from all threads.
class RayLog final : public RenderObserver {
public:
    /// Every ray of `Scene::findClosestIntersection`; directions have unit length.
    [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
    /// Largest number of bounces in a call of `trace` with a ray from the camera, before any
    /// object; -1 without such a call. Reflections have one bounce less.
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

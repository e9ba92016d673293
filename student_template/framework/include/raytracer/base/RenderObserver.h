#ifndef RAYTRACER_BASE_RENDEROBSERVER_H
#define RAYTRACER_BASE_RENDEROBSERVER_H

namespace raytracer {

struct ColourRGB;
struct Ray;
struct RaycastHit;
struct Vector3;
class SceneObject;

/// Observes a renderer without changing it. Every call comes from the thread that does the work, in
/// the order of the work; an implementation that threads share must be thread-safe.
///
/// One pixel of a usual render looks like this:
///   cameraRayAsked, { traceBegan, rayCast, illuminateBegan, rayCast..., illuminateEnded,
///   [traceBegan ... traceEnded for the reflection], traceEnded }..., pixelSet
class RenderObserver {
public:
    RenderObserver() = default;
    virtual ~RenderObserver() = default;
    RenderObserver(const RenderObserver&) = delete;
    RenderObserver& operator=(const RenderObserver&) = delete;

    /// `Camera::castRay(x, y)` was called; `ray` is its result.
    virtual void cameraRayAsked(int x, int y, const Ray& ray) = 0;
    /// `Renderer::trace` starts on `ray`; the next `rayCast` of this thread is that ray.
    virtual void traceBegan(const Ray& ray, int bouncesLeft) = 0;
    /// `Renderer::trace` returns `colour`.
    virtual void traceEnded(const ColourRGB& colour) = 0;
    /// `Renderer::trace` is about to call `illuminate` with these arguments.
    virtual void illuminateBegan(const SceneObject& object, const Vector3& position,
                                 const Vector3& normal, const Vector3& viewer) = 0;
    /// `illuminate` returned `colour` to `Renderer::trace`.
    virtual void illuminateEnded(const ColourRGB& colour) = 0;
    /// `Scene::findClosestIntersection(ray)` was called; `hit` is null for a miss.
    virtual void rayCast(const Ray& ray, const RaycastHit* hit) = 0;
    /// `Image::set(x, y, colour)` was called on an image made from the observed settings.
    virtual void pixelSet(int x, int y, const ColourRGB& colour) = 0;
};

/// Receives the progress of a render and may stop it.
class RenderMonitor {
public:
    RenderMonitor() = default;
    virtual ~RenderMonitor() = default;
    RenderMonitor(const RenderMonitor&) = delete;
    RenderMonitor& operator=(const RenderMonitor&) = delete;

    /// A row of pixels is finished. Called from the thread that rendered it.
    /// @param row   Row of the image, 0 at the top.
    /// @param done  Rows finished so far, this one included.
    /// @param rows  Rows in the image.
    virtual void rowFinished(int row, int done, int rows) = 0;
    /// True when the render should stop after the rows under way; the rest stays black.
    [[nodiscard]] virtual bool interrupted() const = 0;
};

}  // namespace raytracer

#endif

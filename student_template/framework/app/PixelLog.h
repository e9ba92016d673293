#ifndef RAYTRACER_APP_PIXELLOG_H
#define RAYTRACER_APP_PIXELLOG_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/geometry/RaycastHit.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>

#include <optional>
#include <vector>

namespace raytracer {

/// A ray and its hit; empty for a miss.
struct SeenRay {
    Ray ray;
    std::optional<RaycastHit> hit;
};

/// One call of `Renderer::trace`, with everything that happened in it.
struct TracedRay {
    Ray ray;
    int bouncesLeft = 0;
    std::optional<RaycastHit> hit;
    std::vector<SeenRay> shadowRays;   ///< cast within `illuminate`
    std::optional<ColourRGB> direct;   ///< result of `illuminate`; empty if it was not called
    std::vector<TracedRay> reflected;  ///< none or one
    ColourRGB colour;                  ///< result of `trace`
};

/// Records all events while one pixel is rendered on one thread.
class PixelLog final : public RenderObserver {
public:
    [[nodiscard]] const std::vector<TracedRay>& traced() const { return traced_; }
    /// All other rays: those cast outside of `trace`, and those cast in it outside of `illuminate`
    /// after the traced ray itself.
    [[nodiscard]] const std::vector<SeenRay>& loose() const { return loose_; }
    /// The pinhole camera's ray, if the solution asked for it.
    [[nodiscard]] const std::optional<Ray>& cameraRay() const { return cameraRay_; }
    /// The pixel's colour, if the solution set it.
    [[nodiscard]] const std::optional<ColourRGB>& pixel() const { return pixel_; }

    void cameraRayAsked(int x, int y, const Ray& ray) override;
    void traceBegan(const Ray& ray, int bouncesLeft) override;
    void traceEnded(const ColourRGB& colour) override;
    void illuminateBegan(const SceneObject& object, const Vector3& position, const Vector3& normal,
                         const Vector3& viewer) override;
    void illuminateEnded(const ColourRGB& colour) override;
    void rayCast(const Ray& ray, const RaycastHit* hit) override;
    void pixelSet(int x, int y, const ColourRGB& colour) override;

private:
    struct OpenCall {
        TracedRay traced;
        bool hasCast = false;
        bool illuminates = false;
    };
    std::vector<OpenCall> open_;
    std::vector<TracedRay> traced_;
    std::vector<SeenRay> loose_;
    std::optional<Ray> cameraRay_;
    std::optional<ColourRGB> pixel_;
};

}  // namespace raytracer

#endif

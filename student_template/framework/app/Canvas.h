#ifndef RAYTRACER_APP_CANVAS_H
#define RAYTRACER_APP_CANVAS_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/image/Image.h>
#include <raytracer/io/ImageReader.h>

#include <functional>
#include <mutex>

namespace raytracer {

/// Ends a render that ignores its monitor; thrown out of `Image::set`.
struct RenderStopped {};

/// Keeps a copy of every pixel that a render sets, so that an unfinished picture can be shown and
/// saved.
class Canvas final : public RenderObserver {
public:
    /// @param settings     Settings of the observed render.
    /// @param interrupted  Returns true once the render should stop.
    Canvas(const RenderSettings& settings, std::function<bool()> interrupted);

    /// The pixels so far; the rest is black.
    [[nodiscard]] Image picture() const;
    /// The same through the tone curve.
    [[nodiscard]] ByteImage bytes() const;

    void cameraRayAsked(int, int, const Ray&) override {}
    void traceBegan(const Ray&, int) override {}
    void traceEnded(const ColourRGB&) override {}
    void illuminateBegan(const SceneObject&, const Vector3&, const Vector3&,
                         const Vector3&) override {}
    void illuminateEnded(const ColourRGB&) override {}
    void rayCast(const Ray&, const RaycastHit*) override {}
    /// @throws RenderStopped if far more pixels arrive after an interrupt than `forEachPixel` would
    ///         still set: then the solution loops over the pixels itself.
    void pixelSet(int x, int y, const ColourRGB& colour) override;

private:
    mutable std::mutex mutex_;
    Image picture_;
    ByteImage bytes_;
    std::function<bool()> interrupted_;
    int pixelsToCome_;
};

}  // namespace raytracer

#endif

#ifndef RAYTRACER_RENDER_RENDERER_H
#define RAYTRACER_RENDER_RENDERER_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/geometry/SceneObject.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/image/Image.h>
#include <raytracer/math/Ray.h>
#include <raytracer/render/ForEachPixel.h>
#include <raytracer/scene/Camera.h>
#include <raytracer/scene/Scene.h>

namespace raytracer {

/// Turns a scene into a picture.
class Renderer {
public:
    explicit Renderer(const RenderSettings& settings) : settings_(settings) {}

    [[nodiscard]] const RenderSettings& settings() const { return settings_; }

    /// The picture of a scene, in linear colours. Starred exercise: task T2.2, in
    /// exercise/Renderer.cpp.
    [[nodiscard]] Image render(const Scene& scene) const;

    /// The colour that arrives along a ray: direct light, and mirrored light over up to
    /// `bouncesLeft` reflections. Main tick: task M4, in exercise/Renderer.cpp; given in the
    /// starred exercise.
    [[nodiscard]] ColourRGB trace(const Scene& scene, const Ray& ray, int bouncesLeft) const;

    /// The light that a point sends to a viewer, by Phong's model: ambient, diffuse and specular.
    /// In exercise/Renderer.cpp: tasks M2 and M3.2 of the main tick, T2.1 of the starred exercise.
    ///
    /// @param object  The surface that the point lies on.
    /// @param P       The point, world space.
    /// @param N       Its unit normal, world space.
    /// @param O       Where the point is seen from: the origin of the ray that hit it.
    [[nodiscard]] ColourRGB illuminate(const Scene& scene, const SceneObject& object,
                                       const Vector3& P, const Vector3& N, const Vector3& O) const;

private:
    RenderSettings settings_;
};

/// Colour of a ray that hits nothing.
inline constexpr ColourRGB kBackgroundColour{0.001};

/// Shadow bias: how far above its surface a ray starts, world units, so that it does not hit that
/// surface again (shadow acne).
inline constexpr double kShadowBias = 1e-4;

}  // namespace raytracer

#endif

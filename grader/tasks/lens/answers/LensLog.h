#ifndef TICKER_TASKS_LENS_ANSWERS_LENSLOG_H
#define TICKER_TASKS_LENS_ANSWERS_LENSLOG_H

#include <grader/probe/Question.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

using probe::ColourRGB;
using probe::Vector3;

/// One ray that entered the scene from outside, through the lens.
struct LensRay {
    Vector3 origin;
    Vector3 direction;               ///< unit
    std::optional<ColourRGB> value;  ///< what `trace` returned, or recomputed; may be missing
    ColourRGB ambient;               ///< its right value: the questions have no light
    int bounces = -1;                ///< argument of `trace`; -1 without a call
};

/// One pixel of one repetition.
struct LensPixel {
    int repetition = 0;
    Vector3 pinhole;  ///< unit direction of the camera's ray
    ColourRGB colour;
    std::vector<LensRay> rays;
};

struct LensLog {
    const probe::RenderQuestion* asked = nullptr;
    std::vector<LensPixel> pixels;  ///< repetition by repetition, rows from the top
    bool cut = false;               ///< more events than the log holds
    /// Colours of rays that were not traced are computed from what the rays met.
    bool recomputed = false;
    /// Rays may go through any place of their pixel: they stayed inside small pixels, too.
    bool mayAntialias = false;

    [[nodiscard]] std::size_t rayCount() const;
};

/// Whether pixels exist whose rays cannot be judged: without any ray, or with an extra ray alone.
[[nodiscard]] bool lacksRays(const LensLog& log);

/// Finds the lens rays and the pixel of each. A ray belongs to the pixel that is set next after it.
/// If that leaves some pixel without all its rays, because loops run in another order, a ray
/// belongs to the pixel of the camera ray before it, or else to the pixel whose focal point it
/// passes nearest. The same holds for a ray of a thread that sets no pixel and asks for no camera
/// ray, but traces a part of the rays for a thread that does. A ray that hits nothing and is
/// therefore not traced counts as traced. `asked` must outlive the log.
[[nodiscard]] LensLog readLensLog(const probe::RenderQuestion& asked,
                                  const probe::RenderAnswer& answer);

/// Unit direction from the eye through the centre of a pixel, as `Camera` computes it.
[[nodiscard]] Vector3 pinholeDirection(const raytracer::RenderSettings& settings, int x, int y);

/// Half of a pixel's side at a distance of 1, in a picture of this width.
[[nodiscard]] double halfPixel(int width);

/// The point where the pinhole ray of a pixel meets the focal plane.
[[nodiscard]] Vector3 focalPointOf(const LensPixel& pixel,
                                   const raytracer::RenderSettings& settings);

}  // namespace ticker::tasks

#endif

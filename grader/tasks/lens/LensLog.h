#ifndef TICKER_TASKS_DISTRIBUTED_LENSLOG_H
#define TICKER_TASKS_DISTRIBUTED_LENSLOG_H

#include <grader/probe/Question.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

using probe::ColourRGB;
using probe::Vector3;

/// One ray that entered the scene from outside: through the lens.
struct LensRay {
    Vector3 origin;
    Vector3 direction;               ///< unit
    std::optional<ColourRGB> value;  ///< what `trace` gave; empty where another recursion was used
    ColourRGB ambient;               ///< what it must have given there: the questions have no light
    int bounces = -1;                ///< as `trace` was asked; -1 where it was not
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
    bool cut = false;               ///< more happened than the log had room for
    /// Its rays may go through any place of their pixel: they did so in a fine picture.
    bool mayAntialias = false;

    [[nodiscard]] std::size_t rayCount() const;
};

/// Finds the lens rays and the pixel of each: what was traced before a pixel was set belongs to it;
/// where loops run in another order, what followed the pixel's camera ray; else the pixel whose
/// focal point is nearest. A ray that hit nothing and was therefore not traced counts as if it had
/// been. `asked` must live as long as the log.
[[nodiscard]] LensLog readLensLog(const probe::RenderQuestion& asked,
                                  const probe::RenderAnswer& answer);

/// Unit direction from the eye through the middle of a pixel, as `Camera` has it.
[[nodiscard]] Vector3 pinholeDirection(const raytracer::RenderSettings& settings, int x, int y);

/// Where the pinhole ray of a pixel meets the focal plane.
[[nodiscard]] Vector3 focalPointOf(const LensPixel& pixel,
                                   const raytracer::RenderSettings& settings);

}  // namespace ticker::tasks

#endif

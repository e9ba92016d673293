#ifndef TICKER_TASKS_SCREENSHOT_RELIEF_H
#define TICKER_TASKS_SCREENSHOT_RELIEF_H

#include <grader/tasks/screenshot/ShownScene.h>

namespace ticker::tasks::screenshot {

/// The relief of a bump map in a picture, compared with the relief in this code's render of a
/// scene, at a resolution that survives the blur of the lens and soft shadows.
struct Relief {
    /// Correlation. Measured with right and wrong code, with and without a lens: at least 0.48 for
    /// the same map under the signs of one reading, at most 0.17 for another map.
    double likeness = 0.0;
    double strength =
        0.0;  ///< the picture's strength divided by the code's: about 0.55 through the lens
};

/// @param scene  A scene with a bump map that the code rendered. Its height map and the picture's
///               size do not matter.
[[nodiscard]] Relief reliefOf(const ByteView& picture, const Scene& scene);

/// Whether the picture has the code's own relief, whatever was done to its pixels.
[[nodiscard]] bool isSame(const Relief& relief);

/// Whether the picture has the map's relief, but weaker, as through the lens and under soft
/// shadows.
[[nodiscard]] bool isSofter(const Relief& relief);

/// Whether the picture shows the relief of one scene (`here`) and not that of another (`there`).
[[nodiscard]] bool isRather(const Relief& here, const Relief& there);

}  // namespace ticker::tasks::screenshot

#endif

#ifndef TICKER_TASKS_SCREENSHOT_RELIEF_H
#define TICKER_TASKS_SCREENSHOT_RELIEF_H

#include <grader/tasks/screenshot/Scene.h>

namespace ticker::tasks::screenshot {

/// What a bump map leaves in a picture, as coarse as a blur by the lens and soft shadows let
/// through, beside what it leaves in this code's picture of a scene.
struct Relief {
    /// Correlation. Measured on right and wrong code, with and without a lens: from 0.48 upwards
    /// for the same map rendered with the signs of one reading, at most 0.17 for another map.
    double likeness = 0.0;
    double strength = 0.0;  ///< of the picture's over the code's: about 0.55 through the lens
};

/// @param scene  One with a bump map that the code rendered. Neither its height map nor the
///               picture's size matter.
[[nodiscard]] Relief reliefOf(const ByteView& picture, const Scene& scene);

/// As this code makes it, whatever was done to the pixels.
[[nodiscard]] bool isSame(const Relief& relief);

/// Through the lens and under soft shadows: the map's relief, but weaker.
[[nodiscard]] bool isSofter(const Relief& relief);

/// The picture shows the relief of this scene's map and not that of the other's.
[[nodiscard]] bool isRather(const Relief& here, const Relief& there);

}  // namespace ticker::tasks::screenshot

#endif

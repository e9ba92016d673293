#ifndef TICKER_TASKS_DISTRIBUTED_KNOWNCOLOURS_H
#define TICKER_TASKS_DISTRIBUTED_KNOWNCOLOURS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <vector>

namespace ticker::tasks {

/// What a point has where nothing shades it from any light.
[[nodiscard]] ColourRGB inFullLight(const PointLog& point,
                                    const raytracer::SceneDescription& scene);

/// Whether two colours differ by at most `slack`, channel by channel.
[[nodiscard]] bool near(const ColourRGB& a, const ColourRGB& b, const ColourRGB& slack);

/// Whether a point that lies in full light or full shadow of every light has about the colour that
/// geometry gives it; true for all others. Readings with a term for each sample differ from the
/// central one by terms of the light's angular size.
[[nodiscard]] bool isNearKnown(const PointLog& point, const ShadowLog& log, bool viewerIsEye);

/// The same of all points.
[[nodiscard]] bool allNearKnown(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);

/// The finding of a mistake that has a name; `arithmetic` is none of right and endless.
[[nodiscard]] Finding findingOf(ShadowArithmetic arithmetic);

/// Lights that are lost where another one shines on the back of the surface.
[[nodiscard]] Finding lightsLostBehind();

/// The ambient light is there once for each light.
[[nodiscard]] Finding ambientForEachLight();

/// Of several objects one casts its shadow alone.
[[nodiscard]] Finding oneObjectCasts();

/// One object before the light casts its shadow, and several in line with it do not.
[[nodiscard]] Finding hitsMistaken();

/// Planes cast no shadow, spheres do.
[[nodiscard]] Finding planesCastNothing();

/// Every mistake that `findingOf` knows, in the order in which they are tried.
[[nodiscard]] const std::vector<ShadowArithmetic>& namedMistakes();

}  // namespace ticker::tasks

#endif

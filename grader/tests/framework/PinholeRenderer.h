#ifndef TICKER_TESTS_FRAMEWORK_PINHOLERENDERER_H
#define TICKER_TESTS_FRAMEWORK_PINHOLERENDERER_H

#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <vector>

namespace ticker {

/// The 8-bit picture of a scene through a pinhole with one hard shadow ray for each light: rows
/// from the top, red, green, blue.
///
/// Written from the formulas of the rendering semantics alone, with other methods than the
/// framework where possible: it shares no intersection, camera, shading or tone curve with it.
[[nodiscard]] std::vector<std::uint8_t> renderPinhole(const raytracer::SceneDescription& scene,
                                                      int width, int height, int bounces);

}  // namespace ticker

#endif

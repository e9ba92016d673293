#ifndef TICKER_PROBE_SCENEWIRE_H
#define TICKER_PROBE_SCENEWIRE_H

#include <grader/probe/ByteStream.h>

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/scene/SceneDescription.h>

namespace ticker::probe {

inline constexpr int kLargestMapSide = 16384;  ///< same limit as raytracer/io/ImageReader.h

/// Throws a raytracer::Error that says what is wrong with the questions.
[[noreturn]] void refuse(const char* what);

// Height maps and scenes inside a message.
void putMap(ByteWriter& writer, const raytracer::HeightMap& map);
[[nodiscard]] raytracer::HeightMap getMap(ByteReader& reader);
void putScene(ByteWriter& writer, const raytracer::SceneDescription& scene);
[[nodiscard]] raytracer::SceneDescription getScene(ByteReader& reader);

}  // namespace ticker::probe

#endif

#ifndef RAYTRACER_IO_SCENEREADER_H
#define RAYTRACER_IO_SCENEREADER_H

#include <raytracer/scene/SceneDescription.h>

#include <filesystem>

namespace raytracer {

/// Reads a scene file.
///
/// Elements of `<scene>`: `ambient-light` (colour, intensity; at most one), `point-light` (x, y, z,
/// colour, intensity), `sphere` (x, y, z, radius, colour, kD, kS, alphaS, reflectivity),
/// `bumpy-sphere` (the same and bump-map), `plane` (x, y, z, nx, ny, nz, colour, kD, kS, alphaS,
/// reflectivity). `colour`, `bump-map` and a plane's normal are required, the rest has defaults; at
/// least one object is needed. A bump map is looked up beside the scene file, then in `assets`; two
/// spheres with the same map share it.
///
/// Ranges: radius above 0; kD, kS, alphaS and intensity not negative; reflectivity 0 to 1; all
/// numbers from -1e9 to 1e9. Colours are `#RRGGBB`, divided by 255 without sRGB decoding.
///
/// @param file    The XML file; at most 1 MiB and 10 000 elements.
/// @param assets  Folder of shared maps; may be empty.
/// @throws InputError with file, line and what was expected: broken XML, an unknown element or
///         attribute, a number that is not finite or out of range, a missing colour, a map that is
///         missing, outside the two folders or no picture, maps of more than 64 million texels in
///         all.
[[nodiscard]] SceneDescription readScene(const std::filesystem::path& file,
                                         const std::filesystem::path& assets);

}  // namespace raytracer

#endif

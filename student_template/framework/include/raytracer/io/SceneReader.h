#ifndef RAYTRACER_IO_SCENEREADER_H
#define RAYTRACER_IO_SCENEREADER_H

#include <raytracer/scene/SceneDescription.h>

#include <filesystem>

namespace raytracer {

/// Reads a scene file.
///
/// Elements of `<scene>`: `ambient-light` (colour, intensity), `point-light` (x, y, z, colour,
/// intensity), `sphere` (x, y, z, radius, colour, kD, kS, alphaS, reflectivity), `bumpy-sphere`
/// (the same and bump-map), `plane` (x, y, z, nx, ny, nz, colour, kD, kS, alphaS, reflectivity). A
/// bump map is looked up beside the scene file, then in `assets`.
///
/// @param file    The XML file; at most 1 MiB and 10 000 elements.
/// @param assets  Folder of shared maps; may be empty.
/// @throws InputError with file, line and what was expected: broken XML, an unknown element or
///         attribute, a number that is no finite number or out of range, a missing colour, a map
///         that is missing, outside the two folders or no picture.
[[nodiscard]] SceneDescription readScene(const std::filesystem::path& file,
                                         const std::filesystem::path& assets);

}  // namespace raytracer

#endif

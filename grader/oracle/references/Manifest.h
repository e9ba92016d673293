#ifndef TICKER_ORACLE_MANIFEST_H
#define TICKER_ORACLE_MANIFEST_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace ticker::oracle {

/// Provenance of one reference.
struct Provenance {
    std::string sceneHash;
    raytracer::RenderSettings settings;
    bool pinhole = false;
    std::int64_t lensPaths = 0;
    double rmsError = 0.0;
    std::string seedHash;  ///< equal for references that share a seed; the seed itself is left out
    std::string toolVersion;
    std::string instructionSet;
};

/// By name of the reference.
using Manifest = std::map<std::string, Provenance>;

/// Hash of everything in a scene that a renderer can see, 16 hexadecimal digits (FNV-1a).
[[nodiscard]] std::string sceneHash(const raytracer::SceneDescription& scene);

/// Hash of a number, likewise.
[[nodiscard]] std::string numberHash(std::uint64_t number);

/// The manifest of a folder; empty if the folder has no manifest.
/// @throws raytracer::InputError if it is damaged.
[[nodiscard]] Manifest readManifest(const std::filesystem::path& folder);

/// Writes the manifest atomically.
void writeManifest(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace ticker::oracle

#endif

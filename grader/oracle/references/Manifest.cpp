#include <grader/oracle/references/Manifest.h>

#include <grader/base/WholeFile.h>
#include <grader/oracle/references/FloatTiff.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <bit>

namespace ticker::oracle {
namespace {

using Json = nlohmann::ordered_json;

/// Fowler, Noll and Vo's hash 1a, 64 bits.
class Hash {
public:
    void add(std::uint64_t value) {
        for (int i = 0; i < 8; ++i) {
            state_ = (state_ ^ (value & 0xFFU)) * 0x100000001B3U;
            value >>= 8U;
        }
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const raytracer::Vector3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const raytracer::ColourRGB& c) {
        add(c.r);
        add(c.g);
        add(c.b);
    }
    void add(const raytracer::Material& material) {
        add(material.colour);
        add(material.phongKD);
        add(material.phongKS);
        add(material.phongAlpha);
        add(material.reflectivity);
    }
    void add(const raytracer::HeightMap& map) {
        for (int row = 0; row < map.height(); ++row)
            for (int column = 0; column < map.width(); ++column)
                add(map.at(column, row));
    }
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", state_); }

private:
    std::uint64_t state_ = 0xCBF29CE484222325U;
};

Json toJson(const Provenance& p) {
    const raytracer::RenderSettings& s = p.settings;
    return {{"sceneHash", p.sceneHash},
            {"width", s.imageWidth()},
            {"height", s.imageHeight()},
            {"bounces", s.bounces},
            {"shadowRayCount", p.pinhole ? 1 : s.shadowRayCount},
            {"lightSize", p.pinhole ? 0.0 : s.lightSize},
            {"dofRayCount", p.pinhole ? 1 : s.dofRayCount},
            {"dofFocalPlane", s.dofFocalPlane},
            {"dofAmount", p.pinhole ? 0.0 : s.dofAmount},
            {"pinhole", p.pinhole},
            {"lensPaths", p.lensPaths},
            {"rmsError", p.rmsError},
            {"seedHash", p.seedHash},
            {"toolVersion", p.toolVersion},
            {"instructionSet", p.instructionSet}};
}

Provenance provenanceOf(const Json& json) {
    Provenance p;
    p.sceneHash = json.at("sceneHash");
    p.settings.width = json.at("width");
    p.settings.height = json.at("height");
    p.settings.bounces = json.at("bounces");
    p.settings.shadowRayCount = json.at("shadowRayCount");
    p.settings.lightSize = json.at("lightSize");
    p.settings.dofRayCount = json.at("dofRayCount");
    p.settings.dofFocalPlane = json.at("dofFocalPlane");
    p.settings.dofAmount = json.at("dofAmount");
    p.pinhole = json.at("pinhole");
    p.lensPaths = json.at("lensPaths");
    p.rmsError = json.at("rmsError");
    p.seedHash = json.at("seedHash");
    p.toolVersion = json.at("toolVersion");
    p.instructionSet = json.at("instructionSet");
    return p;
}

std::filesystem::path fileIn(const std::filesystem::path& folder) {
    return folder / "manifest.json";
}

}  // namespace

std::string sceneHash(const raytracer::SceneDescription& scene) {
    Hash hash;
    hash.add(scene.ambientLighting);
    for (const raytracer::PointLight& light : scene.pointLights) {
        hash.add(light.position());
        hash.add(light.colour());
        hash.add(light.intensity());
    }
    for (const raytracer::SphereDescription& sphere : scene.spheres) {
        hash.add(sphere.centre);
        hash.add(sphere.radius);
        hash.add(sphere.material);
        if (sphere.heightMap != nullptr) hash.add(*sphere.heightMap);
    }
    for (const raytracer::PlaneDescription& plane : scene.planes) {
        hash.add(plane.point);
        hash.add(plane.normal);
        hash.add(plane.material);
    }
    return hash.text();
}

std::string numberHash(std::uint64_t number) {
    Hash hash;
    hash.add(number);
    return hash.text();
}

Manifest readManifest(const std::filesystem::path& folder) {
    const auto text = readIfThere(fileIn(folder));
    if (!text) return {};
    try {
        Manifest manifest;
        const Json json = Json::parse(*text);
        for (const auto& [name, entry] : json.at("references").items())
            manifest[name] = provenanceOf(entry);
        return manifest;
    } catch (const Json::exception& error) {
        throw raytracer::InputError(fileIn(folder).string(), 0, error.what());
    }
}

void writeManifest(const Manifest& manifest, const std::filesystem::path& folder) {
    Json references = Json::object();
    for (const auto& [name, provenance] : manifest)
        references[name] = toJson(provenance);
    const Json json{{"schemaVersion", 1}, {"references", references}};
    writeAtomically(json.dump(2) + "\n", fileIn(folder));
}

}  // namespace ticker::oracle

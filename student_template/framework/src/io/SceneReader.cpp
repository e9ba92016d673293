#include "Attributes.h"
#include "MapFinder.h"
#include "Xml.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/io/SceneReader.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace raytracer {
namespace {

using Names = std::span<const std::string_view>;

constexpr auto kElements = std::to_array<std::string_view>(
    {"ambient-light", "point-light", "sphere", "bumpy-sphere", "plane"});
constexpr auto kAmbientLightNames = std::to_array<std::string_view>({"colour", "intensity"});
constexpr auto kPointLightNames =
    std::to_array<std::string_view>({"x", "y", "z", "colour", "intensity"});
constexpr auto kSphereNames = std::to_array<std::string_view>(
    {"x", "y", "z", "radius", "colour", "kD", "kS", "alphaS", "reflectivity"});
constexpr auto kBumpySphereNames = std::to_array<std::string_view>(
    {"x", "y", "z", "radius", "colour", "bump-map", "kD", "kS", "alphaS", "reflectivity"});
constexpr auto kPlaneNames = std::to_array<std::string_view>(
    {"x", "y", "z", "nx", "ny", "nz", "colour", "kD", "kS", "alphaS", "reflectivity"});

constexpr double kDefaultIntensity = 100.0;
// Normalising a shorter normal would lose digits.
constexpr double kShortestNormal = 1e-9;
// All maps of a scene together: 512 MB of heights.
constexpr std::int64_t kMostTexels = 64'000'000;

Vector3 positionOf(const Attributes& attributes) {
    return {attributes.number("x", 0.0, kAnyNumber), attributes.number("y", 0.0, kAnyNumber),
            attributes.number("z", 0.0, kAnyNumber)};
}

Material materialOf(const Attributes& attributes) {
    const Material usual;
    return {attributes.colour(), attributes.number("kD", usual.phongKD, kNotNegative),
            attributes.number("kS", usual.phongKS, kNotNegative),
            attributes.number("alphaS", usual.phongAlpha, kNotNegative),
            attributes.number("reflectivity", usual.reflectivity, kShare)};
}

/// Adds the elements of one file to a description.
class SceneBuilder {
public:
    SceneBuilder(const std::filesystem::path& file, const std::filesystem::path& assets)
        : file_(file.string()),
          maps_(
              {file.has_parent_path() ? file.parent_path() : std::filesystem::path("."), assets}) {}

    void add(const XmlElement& element) {
        if (element.name == "ambient-light") return addAmbientLight(element);
        if (element.name == "point-light") return addPointLight(element);
        if (element.name == "sphere") return addSphere(element);
        if (element.name == "bumpy-sphere") return addBumpySphere(element);
        if (element.name == "plane") return addPlane(element);
        throw InputError(file_, element.line,
                         "unknown element " + inQuotes(element.name) + " in <scene>" +
                             knownNamesHint(element.name, kElements));
    }

    SceneDescription take() { return std::move(scene_); }

private:
    void addAmbientLight(const XmlElement& element) {
        const Attributes attributes = read(element, kAmbientLightNames);
        if (ambientLine_ > 0)
            attributes.fail("a second <ambient-light>; the first stands in line " +
                            std::to_string(ambientLine_) + ", delete one");
        ambientLine_ = element.line;
        scene_.ambientLighting =
            attributes.colour() * attributes.number("intensity", 1.0, kNotNegative);
    }

    void addPointLight(const XmlElement& element) {
        const Attributes attributes = read(element, kPointLightNames);
        scene_.pointLights.emplace_back(
            positionOf(attributes), attributes.colour(),
            attributes.number("intensity", kDefaultIntensity, kNotNegative));
    }

    void addSphere(const XmlElement& element) { addSphere(read(element, kSphereNames), nullptr); }

    void addBumpySphere(const XmlElement& element) {
        const Attributes attributes = read(element, kBumpySphereNames);
        addSphere(attributes, mapOf(attributes));
    }

    void addSphere(const Attributes& attributes, std::shared_ptr<const HeightMap> heightMap) {
        scene_.spheres.push_back({positionOf(attributes),
                                  attributes.number("radius", 1.0, kPositive),
                                  materialOf(attributes), std::move(heightMap)});
    }

    void addPlane(const XmlElement& element) {
        const Attributes attributes = read(element, kPlaneNames);
        const Vector3 normal{attributes.number("nx", 0.0, kAnyNumber),
                             attributes.number("ny", 0.0, kAnyNumber),
                             attributes.number("nz", 0.0, kAnyNumber)};
        if (normal.magnitude() < kShortestNormal)
            attributes.fail(
                "the normal (nx, ny, nz) of <plane> is zero; expected a direction, as in "
                "nx=\"0\" ny=\"1\" nz=\"0\"");
        scene_.planes.push_back({positionOf(attributes), normal, materialOf(attributes)});
    }

    std::shared_ptr<const HeightMap> mapOf(const Attributes& attributes) {
        const XmlAttribute& attribute = attributes.required("bump-map");
        const MapFinder::Result found = maps_.find(attribute.value);
        if (found.file.empty()) attributes.fail(attribute, found.problem);
        std::shared_ptr<const HeightMap>& map = loaded_[found.file];
        if (map == nullptr) {
            map = std::make_shared<const HeightMap>(readHeightMap(found.file));
            texels_ += std::int64_t{map->width()} * map->height();
            if (texels_ > kMostTexels)
                attributes.fail(attribute, "maps of at most 64 million texels in one scene");
        }
        return map;
    }

    Attributes read(const XmlElement& element, Names names) const {
        return {file_, element, names};
    }

    std::string file_;
    MapFinder maps_;
    SceneDescription scene_;
    std::map<std::filesystem::path, std::shared_ptr<const HeightMap>> loaded_;
    std::int64_t texels_ = 0;
    int ambientLine_ = 0;
};

}  // namespace

SceneDescription readScene(const std::filesystem::path& file, const std::filesystem::path& assets) {
    const XmlElement root = readXml(file);
    if (root.name != "scene")
        throw InputError(file.string(), root.line,
                         "the outermost element is " + inQuotes(root.name) + "; expected <scene>");
    if (!root.attributes.empty())
        throw InputError(file.string(), root.attributes.front().line,
                         "unknown attribute " + inQuotes(root.attributes.front().name) +
                             " in <scene>, which has none");
    SceneBuilder builder{file, assets};
    for (const XmlElement& element : root.children)
        builder.add(element);
    SceneDescription scene = builder.take();
    if (scene.spheres.empty() && scene.planes.empty())
        throw InputError(file.string(), root.line,
                         "the scene has no object; expected at least one <sphere>, <bumpy-sphere> "
                         "or <plane>");
    return scene;
}

}  // namespace raytracer

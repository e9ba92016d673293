#include <grader/probe/SceneWire.h>

#include <grader/probe/Question.h>

#include <raytracer/base/Error.h>

#include <array>
#include <memory>
#include <string>

namespace ticker::probe {
namespace {

using raytracer::HeightMap;
using raytracer::Material;
using raytracer::PlaneDescription;
using raytracer::PointLight;
using raytracer::SceneDescription;
using raytracer::SphereDescription;

// The height of each byte of a picture.
std::array<double, 256> heightsOfBytes() {
    std::array<double, 256> heights{};
    for (std::size_t byte = 0; byte < heights.size(); ++byte)
        heights[byte] = raytracer::kBumpFactor * static_cast<int>(byte) / 255.0;
    return heights;
}

// The map's heights as bytes of a picture, which take an eighth of the space. Empty if some height
// is not that of a byte.
std::vector<std::uint8_t> asBytes(const HeightMap& map) {
    static const std::array<double, 256> kHeights = heightsOfBytes();
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height()));
    for (int row = 0; row < map.height(); ++row)
        for (int column = 0; column < map.width(); ++column) {
            const double height = map.at(column, row);
            const double level = height * 255.0 / raytracer::kBumpFactor + 0.5;
            if (!(level >= 0.0 && level < 256.0)) return {};
            const auto byte = static_cast<std::uint8_t>(level);
            if (kHeights[byte] != height) return {};
            bytes.push_back(byte);
        }
    return bytes;
}

}  // namespace

void refuse(const char* what) {
    throw raytracer::Error(std::string{"questions: "} + what);
}

void putMap(ByteWriter& writer, const HeightMap& map) {
    const std::vector<std::uint8_t> bytes = asBytes(map);
    std::vector<double> heights;
    if (bytes.empty())
        for (int row = 0; row < map.height(); ++row)
            for (int column = 0; column < map.width(); ++column)
                heights.push_back(map.at(column, row));
    writer.put(map.width());
    writer.put(map.height());
    writer.putAll(bytes);
    writer.putAll(heights);
}

HeightMap getMap(ByteReader& reader) {
    const auto width = reader.get<int>();
    const auto height = reader.get<int>();
    if (width > kLargestMapSide || height > kLargestMapSide) refuse("a map is too large");
    const auto bytes = reader.getAll<std::uint8_t>();
    auto heights = reader.getAll<double>();
    if (!bytes.empty()) return HeightMap::fromBytes(width, height, bytes);
    return {width, height, std::move(heights)};
}

void putScene(ByteWriter& writer, const SceneDescription& scene) {
    writer.put(scene.ambientLighting);
    writer.put(static_cast<std::uint64_t>(scene.pointLights.size()));
    for (const PointLight& light : scene.pointLights) {
        writer.put(light.position());
        writer.put(light.colour());
        writer.put(light.intensity());
    }
    writer.put(static_cast<std::uint64_t>(scene.spheres.size()));
    for (const SphereDescription& sphere : scene.spheres) {
        writer.put(sphere.centre);
        writer.put(sphere.radius);
        writer.put(sphere.material);
        writer.put(static_cast<std::uint32_t>(sphere.heightMap != nullptr));
        if (sphere.heightMap != nullptr) putMap(writer, *sphere.heightMap);
    }
    writer.putAll(scene.planes);
}

SceneDescription getScene(ByteReader& reader) {
    SceneDescription scene;
    scene.ambientLighting = reader.get<ColourRGB>();
    const std::size_t lights = reader.getCount(sizeof(Vector3));
    for (std::size_t i = 0; i < lights; ++i) {
        const auto position = reader.get<Vector3>();
        const auto colour = reader.get<ColourRGB>();
        scene.pointLights.emplace_back(position, colour, reader.get<double>());
    }
    const std::size_t spheres = reader.getCount(sizeof(Vector3));
    for (std::size_t i = 0; i < spheres; ++i) {
        SphereDescription sphere;
        sphere.centre = reader.get<Vector3>();
        sphere.radius = reader.get<double>();
        sphere.material = reader.get<Material>();
        if (reader.get<std::uint32_t>() != 0)
            sphere.heightMap = std::make_shared<const HeightMap>(getMap(reader));
        scene.spheres.push_back(std::move(sphere));
    }
    scene.planes = reader.getAll<PlaneDescription>();
    return scene;
}

}  // namespace ticker::probe

#include <raytracer/base/Error.h>
#include <raytracer/geometry/HeightMap.h>

#include <string>
#include <utility>

namespace raytracer {

HeightMap::HeightMap(int width, int height, std::vector<double> heights)
    : width_(width), height_(height), heights_(std::move(heights)) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < kSmallestSide || height < kSmallestSide)
        throw Error("a height map of " + size + " texels: sides must be at least " +
                        std::to_string(kSmallestSide),
                    ExitCode::badInput);
    if (heights_.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw Error("a height map of " + size + " texels cannot hold " +
                    std::to_string(heights_.size()) + " heights");
}

HeightMap HeightMap::fromBytes(int width, int height, const std::vector<std::uint8_t>& bytes) {
    std::vector<double> heights;
    heights.reserve(bytes.size());
    for (const std::uint8_t byte : bytes)
        heights.push_back(kBumpFactor * byte / 255.0);
    return {width, height, std::move(heights)};
}

void HeightMap::reportOutside(int column, int row) const {
    throw Error("heightMap().at(column " + std::to_string(column) + ", row " + std::to_string(row) +
                ") is outside the map of " + std::to_string(width_) + " x " +
                std::to_string(height_) + " texels");
}

}  // namespace raytracer

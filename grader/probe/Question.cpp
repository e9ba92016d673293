#include <grader/probe/Question.h>

#include <raytracer/base/Error.h>

namespace ticker::probe {
namespace {

std::size_t texelCount(const HeightMapDescription& map) {
    if (map.width < 0 || map.height < 0) return 0;
    return static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
}

}  // namespace

raytracer::HeightMap HeightMapDescription::build() const {
    if (!bytes.empty()) {
        if (bytes.size() != texelCount(*this))
            throw raytracer::Error("a described height map has another number of bytes");
        return raytracer::HeightMap::fromBytes(width, height, bytes);
    }
    if (columns.size() * rows.size() != texelCount(*this) ||
        columns.size() != static_cast<std::size_t>(width))
        throw raytracer::Error("a described height map has another number of columns or rows");
    std::vector<double> heights;
    heights.reserve(texelCount(*this));
    for (const double row : rows)
        for (const double column : columns)
            heights.push_back(column + row);
    return {width, height, std::move(heights)};
}

HeightMapDescription describe(const raytracer::HeightMap& map) {
    HeightMapDescription told{map.width(), map.height(), {}, {}, {}};
    told.bytes.reserve(texelCount(told));
    for (int row = 0; row < map.height(); ++row)
        for (int column = 0; column < map.width(); ++column)
            told.bytes.push_back(static_cast<std::uint8_t>(
                // NOLINTNEXTLINE(bugprone-incorrect-roundings): heights are not negative
                map.at(column, row) * 255.0 / raytracer::kBumpFactor + 0.5));
    return told;
}

}  // namespace ticker::probe

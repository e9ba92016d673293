#ifndef RAYTRACER_GEOMETRY_HEIGHTMAP_H
#define RAYTRACER_GEOMETRY_HEIGHTMAP_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raytracer {

/// The height of a white texel; a black one has the height 0.
inline constexpr double kBumpFactor = 5.0;

/// A grid of heights, read from a bump map. Never changes once built. Column 0 is at the left, row
/// 0 at the top of the picture.
class HeightMap {
public:
    /// The smallest width and height, texels.
    static constexpr int kSmallestSide = 4;

    /// @param heights  width * height values, row after row from the top.
    /// @throws Error if a side is below `kSmallestSide` or the count does not fit.
    HeightMap(int width, int height, std::vector<double> heights);

    /// Heights from bytes: 0 gives 0, 255 gives `kBumpFactor`.
    /// @param bytes  width * height values, row after row from the top.
    /// @throws Error as the constructor.
    [[nodiscard]] static HeightMap fromBytes(int width, int height,
                                             const std::vector<std::uint8_t>& bytes);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Height of one texel; in [0, kBumpFactor] for every map that is read from a picture.
    /// @throws Error with column, row and size if the texel is outside.
    [[nodiscard]] double at(int column, int row) const {
        if (column < 0 || column >= width_ || row < 0 || row >= height_) reportOutside(column, row);
        return heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(column)];
    }

private:
    [[noreturn]] void reportOutside(int column, int row) const;

    int width_;
    int height_;
    std::vector<double> heights_;
};

}  // namespace raytracer

#endif

#ifndef RAYTRACER_IMAGE_IMAGE_H
#define RAYTRACER_IMAGE_IMAGE_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>

#include <cstddef>
#include <vector>

namespace raytracer {

/// A picture in linear colours, black at first. Row 0 is at the top.
/// The tone curve is applied only when it is written, see io/ImageWriter.h.
class Image {
public:
    /// An image of the size that a render with these settings gives.
    /// @throws Error if a side is not in 1..65535.
    explicit Image(const RenderSettings& settings);
    /// @param width, height  Pixels.
    /// @throws Error if a side is not in 1..65535.
    Image(int width, int height);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Sets one pixel. Different pixels may be set from different threads.
    /// @throws Error with x, y and the size if the pixel is outside.
    void set(int x, int y, const ColourRGB& colour);

    /// The colour of one pixel.
    /// @throws Error as for `set`.
    [[nodiscard]] const ColourRGB& at(int x, int y) const;

    /// All colours, row after row from the top.
    [[nodiscard]] const std::vector<ColourRGB>& pixels() const { return pixels_; }

    /// The settings that the image was made from; defaults if it was made from a size.
    [[nodiscard]] const RenderSettings& settings() const { return settings_; }

private:
    [[nodiscard]] std::size_t indexOf(int x, int y) const;

    RenderSettings settings_;
    int width_;
    int height_;
    std::vector<ColourRGB> pixels_;
};

}  // namespace raytracer

#endif

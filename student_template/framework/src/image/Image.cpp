#include <raytracer/base/Error.h>
#include <raytracer/base/RenderObserver.h>
#include <raytracer/image/Image.h>

#include <string>

namespace raytracer {
namespace {

constexpr int kLargestSide = 65535;

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

std::size_t countOf(int width, int height) {
    if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide)
        throw Error("an image of " + sizeText(width, height) + " pixels: sides must be 1 to 65535",
                    ExitCode::badInput);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

Image::Image(const RenderSettings& settings)
    : settings_(settings),
      width_(settings.imageWidth()),
      height_(settings.imageHeight()),
      pixels_(countOf(width_, height_)) {}

Image::Image(int width, int height)
    : width_(width), height_(height), pixels_(countOf(width, height)) {}

void Image::set(int x, int y, const ColourRGB& colour) {
    pixels_[indexOf(x, y)] = colour;
    if (settings_.observer != nullptr) settings_.observer->pixelSet(x, y, colour);
}

const ColourRGB& Image::at(int x, int y) const {
    return pixels_[indexOf(x, y)];
}

std::size_t Image::indexOf(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_)
        throw Error("pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                    ") is outside the image of " + sizeText(width_, height_) + " pixels");
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
}

}  // namespace raytracer
